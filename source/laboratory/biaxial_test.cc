#include <coapt/base/exceptions.h>
#include <coapt/laboratory/biaxial_test.h>
#include <coapt/solid/stability.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace coapt
{
  namespace
  {
    dealii::Tensor<1, 3>
    direction(const std::array<double, 9> &directions, const int k)
    {
      dealii::Tensor<1, 3> result;
      for (int i = 0; i < 3; ++i)
        result[i] = directions[3 * k + i];
      return result;
    }

    std::vector<double>
    positions(const SimplexMesh<3> &mesh)
    {
      std::vector<double> X;
      for (const auto &point : mesh.points)
        for (int d = 0; d < 3; ++d)
          X.push_back(point[d]);
      return X;
    }

    /** Entries of nodal arrays that the test prescribes. */
    std::vector<bool>
    fixed_entries(const Sheet &sheet, const bool has_tensions)
    {
      std::vector<bool> is_fixed(3 * sheet.mesh.points.size(), false);
      for (int d = 0; d < 3; ++d)
        for (const unsigned int node : sheet.held[d])
          is_fixed[3 * node + d] = true;
      if (!has_tensions)
        for (int d = 0; d < 2; ++d)
          for (const unsigned int node : sheet.pulled[d])
            is_fixed[3 * node + d] = true;
      return is_fixed;
    }
  } // namespace

  BiaxialTest::BiaxialTest(const BiaxialParameters &parameters,
                           const BiaxialProtocol &protocol)
    : parameters(parameters)
    , has_tensions(protocol.has_tensions)
    , material(parameters.solid.selected_material())
    , directions(sheet_directions(parameters.fibre_angle))
    , sheet(parameters.side,
            parameters.thickness,
            parameters.n_elements,
            parameters.n_layers)
    , solid(sheet.mesh,
            parameters.solid,
            std::vector<dealii::Tensor<1, 3>>(sheet.mesh.cells.size(),
                                              direction(directions, 0)),
            {},
            MPI_COMM_SELF,
            std::vector<dealii::Tensor<1, 3>>(sheet.mesh.cells.size(),
                                              direction(directions, 2)))
    , is_fixed(fixed_entries(sheet, has_tensions))
    , newton(sheet.mesh, solid, material, directions, is_fixed)
  {
    reset();
    const auto stretches = stretches_of(protocol);
    for (std::size_t i = 0; i < stretches.size(); ++i)
      check_range(stretches[i], protocol.states[i].place);
  }

  void
  BiaxialTest::reset()
  {
    X = positions(sheet.mesh);
    load.assign(X.size(), 0.);
    current = {{has_tensions ? 0. : 1., has_tensions ? 0. : 1.}};
  }

  SheetState
  BiaxialTest::homogeneous(const std::array<double, 2> &stretch) const
  {
    return stretched_sheet(material, stretch[0], stretch[1], directions);
  }

  std::vector<std::array<double, 2>>
  BiaxialTest::stretches_of(const BiaxialProtocol &protocol) const
  {
    std::vector<std::array<double, 2>> result;
    std::array<double, 2> stress{}, stretch{{1, 1}};
    for (std::size_t i = 0; i < protocol.states.size(); ++i)
      {
        const auto &state = protocol.states[i];
        if (!has_tensions)
          {
            result.push_back(state.values);
            continue;
          }
        if (i == 0 || state.protocol != protocol.states[i - 1].protocol)
          {
            stress  = {{0, 0}};
            stretch = {{1, 1}};
          }
        const std::array<double, 2> end = {
          {state.values[0] / parameters.thickness,
           state.values[1] / parameters.thickness}};
        if (!follow_load(stress, end, stretch))
          {
            std::ostringstream message;
            message << state.place << ": the tensions " << state.values[0]
                    << " and " << state.values[1]
                    << " N/m are beyond the range of the material "
                    << parameters.solid.material
                    << ": no stable state of the sheet balances them";
            throw InputError(message.str());
          }
        stress = end;
        result.push_back(stretch);
      }
    return result;
  }

  bool
  BiaxialTest::follow_load(const std::array<double, 2> &begin,
                           const std::array<double, 2> &end,
                           std::array<double, 2> &stretch) const
  {
    double done = 0, part = 1;
    while (done < 1)
      {
        std::array<double, 2> stress;
        for (int d = 0; d < 2; ++d)
          stress[d] =
            begin[d] + std::min(done + part, 1.) * (end[d] - begin[d]);
        if (const auto state =
              loaded_sheet(material, stress, directions, stretch))
          {
            stretch = {{state->F[0][0], state->F[1][1]}};
            done += part;
            continue;
          }
        part /= 2;
        if (part < 1e-3)
          return false;
      }
    return true;
  }

  std::string
  BiaxialTest::out_of_range(const std::array<double, 2> &stretch) const
  {
    std::ostringstream message;
    SmallMatrix<3, double> F{};
    F[0][0]      = stretch[0];
    F[1][1]      = stretch[1];
    F[2][2]      = 1 / (stretch[0] * stretch[1]);
    double ratio = 0;
    std::visit(
      [&](const auto &law) { ratio = law.strain_ratio(F, directions.data()); },
      material);
    if (!(ratio <= 1))
      {
        message << "its strain is " << ratio
                << " times the limit of the exponential";
        return message.str();
      }
    try
      {
        F = homogeneous(stretch).F;
      }
    catch (const NumericalError &error)
      {
        return error.what();
      }
    SmallMatrix<3, double> identity{};
    for (int i = 0; i < 3; ++i)
      identity[i][i] = 1;
    const auto moduli_at = [&](const SmallMatrix<3, double> &F) {
      return wave_moduli(tangent_at(material, F, directions));
    };
    const WaveModuli at_rest = moduli_at(identity), moduli = moduli_at(F);
    // Poisson's ratio above 0.44: what keeps the volume must outweigh the rest.
    const bool keeps_volume = at_rest.largest > 10 * at_rest.smallest;
    const double volume     = F[0][0] * F[1][1] * F[2][2];
    const double stiffer    = moduli.largest / at_rest.largest;
    if (keeps_volume && !(volume > 0.5 && volume < 2))
      message << "it is nearly incompressible at rest, but has " << volume
              << " times its volume";
    else if (!(moduli.smallest >= -1e-6 * moduli.largest))
      message << "a plane wave has the modulus " << moduli.smallest << " Pa";
    else if (!(stiffer <= 1e6))
      message << "it is " << stiffer << " times as stiff as at rest";
    return message.str();
  }

  void
  BiaxialTest::check_range(const std::array<double, 2> &stretch,
                           const std::string &place) const
  {
    const std::string problem = out_of_range(stretch);
    if (problem.empty())
      return;
    std::ostringstream message;
    message << place << ": the stretches " << stretch[0] << " and "
            << stretch[1]
            << (has_tensions ? ", which balance the tensions," : "")
            << " are beyond the range of the material "
            << parameters.solid.material << ": " << problem;
    throw InputError(message.str());
  }

  void
  BiaxialTest::impose(const std::array<double, 2> &values)
  {
    for (int d = 0; d < 2; ++d)
      for (unsigned int i = 0; i < sheet.pulled[d].size(); ++i)
        {
          const unsigned int entry = 3 * sheet.pulled[d][i] + d;
          if (has_tensions)
            load[entry] = values[d] / sheet.thickness * sheet.pulled_area[d][i];
          else
            X[entry] = values[d] * sheet.side;
        }
  }

  std::vector<double>
  BiaxialTest::forces() const
  {
    std::vector<double> F = load;
    const std::vector<double> at_rest(X.size(), 0.);
    solid.add_forces(X.data(), at_rest.data(), F.data());
    return F;
  }

  BiaxialResult
  BiaxialTest::measure(const unsigned int n_steps) const
  {
    BiaxialResult result;
    result.n_steps = n_steps;
    std::vector<double> F(X.size(), 0.);
    const std::vector<double> at_rest(X.size(), 0.);
    solid.add_forces(X.data(), at_rest.data(), F.data());
    for (int d = 0; d < 2; ++d)
      {
        double force = 0, stretch = 0;
        for (unsigned int i = 0; i < sheet.pulled[d].size(); ++i)
          {
            const unsigned int entry = 3 * sheet.pulled[d][i] + d;
            force -= F[entry];
            stretch += X[entry] * sheet.pulled_area[d][i];
          }
        result.stress[d]  = force / sheet.side_area();
        result.stretch[d] = stretch / (sheet.side_area() * sheet.side);
      }
    return result;
  }

  BiaxialResult
  BiaxialTest::equilibrium(const BiaxialProtocol::State &state)
  {
    const auto begin = current;
    double done = 0, part = 1;
    unsigned int n_iterations = 0;
    while (done < 1)
      {
        const auto X_before = X;
        std::array<double, 2> values;
        for (int d = 0; d < 2; ++d)
          {
            values[d] = begin[d] +
              std::min(done + part, 1.) * (state.values[d] - begin[d]);
            // The inner nodes follow the sides, at constant volume.
            if (!has_tensions)
              for (std::size_t i = 0; i < X.size(); i += 3)
                {
                  X[i + d] *= values[d] / current[d];
                  X[i + 2] *= current[d] / values[d];
                }
          }
        impose(values);
        const unsigned int n = newton.solve(X, load);
        if (n > 0)
          {
            n_iterations += n;
            done    = std::min(done + part, 1.);
            current = values;
            continue;
          }
        X = X_before;
        part /= 2;
        if (part < 1e-3)
          throw NumericalError(state.place +
                               ": Newton's method finds no equilibrium");
      }
    const BiaxialResult result = measure(n_iterations);
    if (has_tensions)
      check_range(result.stretch, state.place);
    return result;
  }

  BiaxialResult
  BiaxialTest::settle(const BiaxialProtocol::State &state)
  {
    const auto begin = current;
    std::vector<double> V(X.size(), 0.), F = forces();
    double t = 0, dt = 0, damping = 0;
    // Round-off of a nodal force: 1e-13 of what the stiffest motion costs.
    const double frequency = solid.max_frequency(X.data());
    const double round_off = 1e-13 *
      *std::max_element(solid.mass().begin(), solid.mass().end()) * frequency *
      frequency * sheet.side;
    const unsigned int most = 1000000;
    for (unsigned int n = 1; n <= most; ++n)
      {
        if (n % 50 == 1)
          dt = 0.8 * 2 / solid.max_frequency(X.data());
        for (std::size_t i = 0; i < X.size(); ++i)
          if (!is_fixed[i])
            {
              const double a = F[i] / solid.mass()[i / 3];
              V[i]           = (V[i] * (1 - damping * dt / 2) + dt * a) /
                (1 + damping * dt / 2);
              X[i] += dt * V[i];
            }
        t += dt;
        const double s      = std::min(t / parameters.ramp_time, 1.);
        const double smooth = s * s * (3 - 2 * s);
        std::array<double, 2> values;
        for (int d = 0; d < 2; ++d)
          values[d] = begin[d] + smooth * (state.values[d] - begin[d]);
        impose(values);

        const auto before = F;
        F                 = forces();
        double work = 0, energy = 0, scale = 0, rest = 0;
        for (std::size_t i = 0; i < X.size(); ++i)
          {
            scale = std::max(scale, std::abs(F[i] - load[i]));
            if (is_fixed[i])
              continue;
            rest = std::max(rest, std::abs(F[i]));
            work += V[i] * (before[i] - F[i]) / dt;
            energy += V[i] * V[i] * solid.mass()[i / 3];
          }
        if (!std::isfinite(energy))
          break;
        damping = energy > 0 ? 2 * std::sqrt(std::max(work / energy, 0.)) : 0;
        if (s == 1 && rest <= std::max(1e-6 * scale, round_off))
          {
            current = state.values;
            return measure(n);
          }
      }
    throw NumericalError(state.place +
                         ": the explicit method does not come to rest");
  }
} // namespace coapt
