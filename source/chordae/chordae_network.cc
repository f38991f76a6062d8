#include <coapt/base/exceptions.h>
#include <coapt/chordae/chordae_network.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace coapt
{
  namespace
  {
    /** Whether the chorda begins at a node of the arrays. */
    bool
    has_origin_node(const Chorda &chorda)
    {
      return chorda.origin_node != dealii::numbers::invalid_unsigned_int;
    }

    /** Bounds of the square of the frequency (1/s^2) of each node, by the sum
     * of its row of the stiffness matrix; zero for nodes without a string, and
     * for all if no end but those on the leaflet moves. */
    std::vector<double>
    square_frequencies(const std::vector<Chorda> &chordae,
                       const std::vector<double> &axial_stiffness,
                       const std::vector<double> &nodal_mass)
    {
      std::vector<double> row(nodal_mass.size(), 0.);
      bool is_tree = false;
      for (unsigned int i = 0; i < chordae.size(); ++i)
        {
          const Chorda &chorda   = chordae[i];
          const double stiffness = axial_stiffness[i] / chorda.rest_length;
          const bool moves =
            has_origin_node(chorda) && nodal_mass[chorda.origin_node] > 0;
          is_tree = is_tree || moves;
          if (moves)
            row[chorda.origin_node] += 2 * stiffness;
          for (unsigned int k = 0; k < chorda.nodes.size(); ++k)
            row[chorda.nodes[k]] +=
              stiffness * chorda.weights[k] * (moves ? 2 : 1);
        }
      for (unsigned int n = 0; n < row.size(); ++n)
        row[n] = is_tree && row[n] > 0 ? row[n] / nodal_mass[n] : 0.;
      return row;
    }

    void
    check(const Chorda &chorda)
    {
      if (chorda.nodes.empty() || chorda.nodes.size() != chorda.weights.size())
        throw InputError("chorda " + chorda.id +
                         " attached to nothing: it "
                         "has no nodes, or not one weight a node.");
      if (chorda.diameter > 0 && chorda.modulus > 0 && chorda.rest_length > 0)
        return;
      std::ostringstream message;
      message << "chorda " << chorda.id << ": diameter "
              << chorda.diameter * 1e3 << " mm, modulus " << chorda.modulus
              << " Pa, rest length " << chorda.rest_length * 1e3
              << " mm, all must be positive.";
      throw InputError(message.str());
    }
  } // namespace

  ChordaeNetwork::ChordaeNetwork(const std::vector<Chorda> &chordae,
                                 const std::vector<double> &nodal_mass,
                                 const double ramp_time,
                                 const double damping_ratio)
    : all_chordae(chordae), ramp_time(ramp_time), zeta(damping_ratio)
  {
    for (const Chorda &chorda : all_chordae)
      {
        check(chorda);
        double inverse_mass = 0;
        for (unsigned int k = 0; k < chorda.nodes.size(); ++k)
          inverse_mass +=
            chorda.weights[k] * chorda.weights[k] / nodal_mass[chorda.nodes[k]];
        if (has_origin_node(chorda) && nodal_mass[chorda.origin_node] > 0)
          inverse_mass += 1 / nodal_mass[chorda.origin_node];
        mass.push_back(1 / inverse_mass);
        axial_stiffness.push_back(chorda.modulus * dealii::numbers::PI_4 *
                                  chorda.diameter * chorda.diameter);
        damping.push_back(
          2 * damping_ratio *
          std::sqrt(axial_stiffness.back() / chorda.rest_length * mass.back()));
      }
    // Where many strings meet, each damps the motion of the branching; together
    // they are to have the damping ratio.
    const std::vector<double> squares =
      square_frequencies(all_chordae, axial_stiffness, nodal_mass);
    for (unsigned int i = 0; i < all_chordae.size(); ++i)
      {
        double square = has_origin_node(all_chordae[i])
          ? squares[all_chordae[i].origin_node]
          : 0.;
        for (const unsigned int node : all_chordae[i].nodes)
          square = std::max(square, squares[node]);
        if (square > 0)
          damping[i] = 2 * damping_ratio * axial_stiffness[i] /
            all_chordae[i].rest_length / std::sqrt(square);
      }
    for (const double square : squares)
      largest_square_frequency = std::max(largest_square_frequency, square);
    for (unsigned int i = 0; i < all_chordae.size(); ++i)
      largest_square_frequency =
        std::max(largest_square_frequency,
                 axial_stiffness[i] / (all_chordae[i].rest_length * mass[i]));
  }

  dealii::Tensor<1, 3>
  ChordaeNetwork::mean(const Chorda &chorda, const double *x)
  {
    dealii::Tensor<1, 3> sum;
    for (unsigned int k = 0; k < chorda.nodes.size(); ++k)
      for (unsigned int c = 0; c < 3; ++c)
        sum[c] += chorda.weights[k] * x[3 * chorda.nodes[k] + c];
    return sum;
  }

  dealii::Point<3>
  ChordaeNetwork::origin(const Chorda &chorda, const double *X)
  {
    if (!has_origin_node(chorda))
      return chorda.tip;
    const double *x = X + 3 * chorda.origin_node;
    return dealii::Point<3>(x[0], x[1], x[2]);
  }

  double
  ChordaeNetwork::initial_rest_length(const Chorda &chorda) const
  {
    return std::max(1.001 * chorda.open_length, chorda.rest_length);
  }

  ChordaeNetwork::Pull
  ChordaeNetwork::pull(const unsigned int i,
                       const double t,
                       const double *X,
                       const double *V) const
  {
    const Chorda &chorda = all_chordae[i];
    Pull p;
    p.direction = origin(chorda, X) - mean(chorda, X);
    p.length    = p.direction.norm();
    p.direction /= p.length;
    p.rate = V == nullptr ? 0. : -(mean(chorda, V) * p.direction);
    if (V != nullptr && has_origin_node(chorda))
      for (unsigned int c = 0; c < 3; ++c)
        p.rate += V[3 * chorda.origin_node + c] * p.direction[c];

    const double s    = ramp_time > 0 ? std::clamp(t / ramp_time, 0., 1.) : 1.;
    const double rise = s * s * (3 - 2 * s);
    p.rest_length     = chorda.rest_length +
      (1 - rise) * (initial_rest_length(chorda) - chorda.rest_length);

    // Written such that a length that is not a number is not called slack.
    const bool slack = p.length <= p.rest_length;
    p.elastic =
      slack ? 0. : axial_stiffness[i] * (p.length / p.rest_length - 1);
    p.tension = slack ? 0. : p.elastic + damping[i] * p.rate;
    if (p.tension < 0)
      p.tension = 0;
    return p;
  }

  void
  ChordaeNetwork::add_forces(const double t,
                             const double *X,
                             const double *V,
                             double *F,
                             const unsigned int rank,
                             const unsigned int n_ranks) const
  {
    for (unsigned int i = rank; i < all_chordae.size(); i += n_ranks)
      {
        const Chorda &chorda = all_chordae[i];
        const Pull p         = pull(i, t, X, V);
        for (unsigned int k = 0; k < chorda.nodes.size(); ++k)
          for (unsigned int c = 0; c < 3; ++c)
            F[3 * chorda.nodes[k] + c] +=
              chorda.weights[k] * p.tension * p.direction[c];
        if (has_origin_node(chorda))
          for (unsigned int c = 0; c < 3; ++c)
            F[3 * chorda.origin_node + c] -= p.tension * p.direction[c];
      }
  }

  std::vector<double>
  ChordaeNetwork::tensions(const double t,
                           const double *X,
                           const double *V) const
  {
    std::vector<double> result(all_chordae.size());
    for (unsigned int i = 0; i < result.size(); ++i)
      result[i] = pull(i, t, X, V).tension;
    return result;
  }

  double
  ChordaeNetwork::elastic_energy(const double t, const double *X) const
  {
    double energy = 0;
    for (unsigned int i = 0; i < all_chordae.size(); ++i)
      {
        const Pull p = pull(i, t, X, nullptr);
        energy += p.elastic * (p.length - p.rest_length) / 2;
      }
    return energy;
  }

  double
  ChordaeNetwork::damping_power(const double t,
                                const double *X,
                                const double *V) const
  {
    double power = 0;
    for (unsigned int i = 0; i < all_chordae.size(); ++i)
      {
        const Pull p = pull(i, t, X, V);
        power += (p.tension - p.elastic) * p.rate;
      }
    return power;
  }

  double
  ChordaeNetwork::ramp_power(const double t, const double *X) const
  {
    if (!(t > 0 && t < ramp_time))
      return 0;
    const double s = t / ramp_time;
    double power   = 0;
    for (unsigned int i = 0; i < all_chordae.size(); ++i)
      {
        // The energy is E A (l - l0)^2 / (2 l0).
        const Pull p           = pull(i, t, X, nullptr);
        const double shrinking = 6 * s * (1 - s) / ramp_time *
          (initial_rest_length(all_chordae[i]) - all_chordae[i].rest_length);
        power += p.elastic * (1 + p.length / p.rest_length) / 2 * shrinking;
      }
    return power;
  }

  double
  ChordaeNetwork::max_frequency() const
  {
    return std::sqrt(largest_square_frequency);
  }

  std::vector<dealii::Point<3>>
  ChordaeNetwork::attachment_points(const double *X) const
  {
    std::vector<dealii::Point<3>> points;
    for (const Chorda &chorda : all_chordae)
      points.emplace_back(mean(chorda, X));
    return points;
  }

  std::vector<dealii::Point<3>>
  ChordaeNetwork::origins(const double *X) const
  {
    std::vector<dealii::Point<3>> points;
    for (const Chorda &chorda : all_chordae)
      points.push_back(origin(chorda, X));
    return points;
  }

  const std::vector<Chorda> &
  ChordaeNetwork::chordae() const
  {
    return all_chordae;
  }
} // namespace coapt
