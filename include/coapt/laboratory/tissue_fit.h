#ifndef coapt_laboratory_tissue_fit_h
#define coapt_laboratory_tissue_fit_h

#include <coapt/laboratory/biaxial_data.h>
#include <coapt/laboratory/least_squares.h>
#include <coapt/laboratory/tissue_model.h>
#include <coapt/solid/batch.h>

#include <array>
#include <limits>
#include <vector>

namespace coapt
{
  /** How to fit. */
  struct FitOptions
  {
    /** Points along each shape of a grid that covers the box of two shapes. */
    unsigned int grid = 61;

    /** Random starts where there are other numbers of shapes. */
    unsigned int starts = 60;

    /** Seed of these starts. */
    unsigned int seed = 1;

    /** Confidence of all intervals. */
    double confidence = 0.95;
  };

  /** A parameter as fitted. */
  struct FittedVariable
  {
    FitVariable variable;
    double value;

    /** Standard error and confidence interval of the linearised model;
     * infinite if the parameter is on a bound or the others make up for it. */
    double standard_error = std::numeric_limits<double>::infinity();
    double lower = 0, upper = 0;

    /** Where the profile likelihood leaves the confidence region, at the
     * bounds if it does not. */
    double profile_lower = 0, profile_upper = 0;

    /** Whether it does so within the bounds. */
    bool determined_below = false, determined_above = false;

    /** The profile: value, and the sum of squares with the others refitted. */
    std::vector<std::array<double, 2>> profile;
  };

  /** Outcome of a fit. */
  struct FitResult
  {
    std::vector<double> stiffness, shape;
    std::vector<FittedVariable> variables;
    double sum_of_squares = std::numeric_limits<double>::infinity();

    /** Coefficient of determination: of direction 1, of 2, and of both. */
    std::array<double, 3> r_squared;

    /** Mean of 100 |measured - model| / max(measured, model) in percent, over
     * the stresses that are not zero (thesis of Khaledian, 2023, 5.27). */
    double nmad;

    /** Stresses of the model at the data, in their measure (Pa). */
    std::vector<std::array<double, 2>> stress;

    /** Local minima that were refined, and different ones among them. */
    unsigned int n_starts = 0, n_minima = 0;
  };

  /**
   * Least squares between a material and biaxial data of incompressible tissue.
   * For given shapes, the stiffnesses are a problem of non-negative least
   * squares (Kaufman's variable projection): the search is in the shapes only.
   * With two of them, a grid covers the box, and every local minimum of the
   * grid is refined; otherwise the search starts from random places.
   */
  class TissueFit
  {
  public:
    /** @throws InputError if there are fewer stresses than parameters. Both
     * must live as long as this object. */
    TissueFit(const TissueModel &model,
              const BiaxialData &data,
              const FitOptions &options);

    /** The best parameters, with intervals and profiles if @p all. */
    FitResult
    fit(const bool all = true) const;

    /** A local search from these shapes; returns the sum of squares. */
    double
    local_fit(std::vector<double> &shape, std::vector<double> &stiffness) const;

    /** Residuals (Pa) with these parameters. */
    std::vector<double>
    residuals(const std::vector<double> &stiffness,
              const std::vector<double> &shape) const;

    /** Shapes at the fractions @p u of their intervals. */
    std::vector<double>
    shapes_at(const std::vector<double> &u) const;

  private:
    /** A stiffness that is kept at a value. */
    struct Fixed
    {
      int index    = -1;
      double value = 0;
    };

    /** Stresses of a material at the data, in their measure. */
    std::vector<double>
    stresses(const Material &material) const;

    /** Residuals with the best stiffnesses for these shapes. */
    std::vector<double>
    project(const std::vector<double> &shape,
            std::vector<double> &stiffness,
            const Fixed &fixed) const;

    /** The problem in the fractions of the shapes' intervals. */
    LeastSquares
    problem(const Fixed &fixed) const;

    std::vector<std::vector<double>>
    starts() const;
    std::vector<double>
    fractions(const std::vector<double> &shape) const;
    void
    add_intervals(FitResult &result) const;
    void
    add_profile(FitResult &result, const unsigned int number) const;
    void
    follow_profile(const FitResult &result,
                   const unsigned int number,
                   const int side,
                   const double threshold,
                   FittedVariable &fitted) const;
    void
    add_quality(FitResult &result) const;

    const TissueModel &model;
    const BiaxialData &data;
    FitOptions options;
    std::vector<double> measured;
    std::vector<std::array<Batch, 2>> stretches;
  };
} // namespace coapt

#endif
