#!/usr/bin/python3
"""cook_reference.py: Cook's membrane in plane strain with a discretisation that
has nothing in common with the program's, the source of the references for
nearly incompressible material in structures.cc: quadrilaterals of nine nodes
with a discontinuous linear pressure (Q2/P1, stable in the sense of Babuska and
Brezzi), Newton's method.

    W = mu/2 (J^(-2/3) F:F - 3) + p (J - 1) - p^2/(2 K)

Prints the rise (mm) of the upper corner and of the middle of the loaded edge on
n x n elements. The last lines are the case of Simo and Armero (1992),
whose corner rises by 6.9."""
import numpy as np
import scipy.sparse as sparse
import scipy.sparse.linalg as linear


def shape_functions():
    """Values and derivatives of nine nodes, [point, node(, direction)], the
    linear pressure and the weights at 3 x 3 points."""
    x1, w1 = np.polynomial.legendre.leggauss(3)
    x, y = [a.ravel() for a in np.meshgrid(x1, x1, indexing="ij")]
    line = lambda s: np.array([s * (s - 1) / 2, 1 - s * s, s * (s + 1) / 2]).T
    slope = lambda s: np.array([s - 0.5, -2 * s, s + 0.5]).T
    product = lambda a, b: (a[:, :, None] * b[:, None, :]).reshape(9, 9)
    dN = np.stack([product(slope(x), line(y)), product(line(x), slope(y))], axis=2)
    return dN, np.stack([np.ones(9), x, y], axis=1), np.outer(w1, w1).ravel()


def membrane(n):
    """Nodes and elements of n x n quadrilaterals, and the weights of the load
    on the nodes of the edge x = 48."""
    m = 2 * n + 1
    i, j = [a.ravel() for a in np.meshgrid(np.arange(m), np.arange(m), indexing="ij")]
    s, t = i / (m - 1), j / (m - 1)
    X = np.stack([48 * s, (1 - t) * 44 * s + t * (44 + 16 * s)], axis=1)
    first = (2 * np.arange(n)[:, None] * m + 2 * np.arange(n)[None, :]).ravel()
    cells = first[:, None] + (np.arange(3)[:, None] * m + np.arange(3)[None, :]).ravel()
    weights = np.zeros(m)
    for e in range(n):
        weights[2 * e:2 * e + 3] += np.array([1, 4, 1]) / (6 * n)
    return X, cells, (m - 1) * m + np.arange(m), weights


def cook(n, mu, K, force, steps=10):
    """Rise of the corner and of the middle under the force for a unit of depth."""
    dN, Np, w = shape_functions()
    X, cells, edge, weights = membrane(n)
    n_u, n_p = 2 * len(X), 3 * len(cells)
    G = np.einsum("qad,cai->cqid", dN, X[cells])
    dV = np.linalg.det(G) * w
    g = np.einsum("qad,cqdi->cqai", dN, np.linalg.inv(G))
    dofs = np.concatenate(
        [(2 * cells[:, :, None] + np.arange(2)).reshape(len(cells), -1),
         n_u + np.arange(n_p).reshape(-1, 3)], axis=1)
    free = np.setdiff1d(np.arange(n_u + n_p), np.flatnonzero(X[:, 0] < 1e-9)[:, None] * 2
                        + np.arange(2))
    load = np.zeros(n_u + n_p)
    load[2 * edge + 1] = force * weights
    state = np.zeros(n_u + n_p)
    one = np.eye(2)
    for step in range(1, steps + 1):
        for _ in range(30):
            u, p = state[:n_u].reshape(-1, 2)[cells], state[n_u:].reshape(-1, 3)
            F = one + np.einsum("cai,cqaj->cqij", u, g)
            J, H = np.linalg.det(F), np.linalg.inv(F).swapaxes(2, 3)
            pressure, c = p @ Np.T, mu * J ** (-2 / 3)
            I1 = 1 + np.einsum("cqij,cqij->cq", F, F)
            P = c[..., None, None] * (F - (I1 / 3)[..., None, None] * H) \
                + (pressure * J)[..., None, None] * H
            HH = np.einsum("cqij,cqkl->cqijkl", H, H)
            FH = np.einsum("cqij,cqkl->cqijkl", F, H)
            cross = np.einsum("cqil,cqkj->cqijkl", H, H)
            wide = lambda a: a[..., None, None, None, None]
            A = wide(c) * (np.einsum("ik,jl->ijkl", one, one)
                           - 2 / 3 * (FH + FH.transpose(0, 1, 4, 5, 2, 3))
                           + wide(2 / 9 * I1) * HH + wide(I1 / 3) * cross) \
                + wide(pressure * J) * (HH - cross)
            k_uu = np.einsum("cqaj,cqijkl,cqbl,cq->caibk", g, A, g, dV, optimize=True)
            k_up = np.einsum("cqaj,cqij,qm,cq->caim", g, H, Np, dV * J, optimize=True)
            k_pp = -np.einsum("qm,qn,cq->cmn", Np, Np, dV) / K
            k_uu, k_up = k_uu.reshape(len(cells), 18, 18), k_up.reshape(len(cells), 18, 3)
            matrix = np.concatenate(
                [np.concatenate([k_uu, k_up], axis=2),
                 np.concatenate([k_up.swapaxes(1, 2), k_pp], axis=2)], axis=1)
            inner = np.concatenate(
                [np.einsum("cqaj,cqij,cq->cai", g, P, dV).reshape(len(cells), -1),
                 np.einsum("qm,cq->cm", Np, (J - 1 - pressure / K) * dV)], axis=1)
            r = load * step / steps
            np.add.at(r, dofs, -inner)
            if np.linalg.norm(r[free]) < 1e-11 * force:
                break
            shape = (len(cells), 21, 21)
            S = sparse.csc_matrix(
                (matrix.ravel(), (np.broadcast_to(dofs[:, :, None], shape).ravel(),
                                  np.broadcast_to(dofs[:, None, :], shape).ravel())))
            state[free] += linear.spsolve(S[free][:, free], r[free])
        else:
            raise RuntimeError("Newton's method does not converge")
    return state[2 * edge[-1] + 1], state[2 * edge[len(edge) // 2] + 1]


def main():
    mu = 0.4225 # MPa
    for name, mu, nu, force in (("Poisson's ratio 0.3", mu, 0.3, 1), ("0.4999", mu, 0.4999, 1),
                                ("Simo and Armero", 80.1938, None, 100)):
        K = 400942 if nu is None else 2 * mu * (1 + nu) / (3 * (1 - 2 * nu))
        for n in (4, 8, 16, 32):
            corner, middle = cook(n, mu, K, force)
            print(f"{name}, n = {n}: corner {corner:.4f}, middle {middle:.4f}", flush=True)


main()
