#ifndef coapt_laboratory_tissue_model_h
#define coapt_laboratory_tissue_model_h

#include <coapt/solid/materials/material.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace coapt
{
  /** A parameter of a material that is fitted to data. */
  struct FitVariable
  {
    std::string name;
    std::string unit;
    double lowest, highest;

    /** Whether the search treats the logarithm evenly. */
    bool logarithmic;
  };

  /**
   * A material as a fit sees it: its stress is linear in some parameters that
   * must not be negative, the stiffnesses, once the others, its shapes, are
   * given (separable least squares: Golub and Pereyra, 1973).
   */
  class TissueModel
  {
  public:
    virtual ~TissueModel() = default;

    /** Stiffnesses; only their lower bounds are kept. */
    std::vector<FitVariable> stiffnesses;

    /** Shapes, within their bounds. */
    std::vector<FitVariable> shapes;

    /** Name of the material. */
    virtual std::string
    name() const = 0;

    /** The material with these parameters, its formula without any limit. */
    virtual Material
    material(const std::vector<double> &stiffness,
             const std::vector<double> &shape) const = 0;

    /** Entries of the material's subsection in a parameter file; @p limit is
     * the value of "Exponential limit", if it has one. */
    virtual std::vector<std::pair<std::string, std::string>>
    entries(const std::vector<double> &stiffness,
            const std::vector<double> &shape,
            const double limit) const = 0;

    /** Name of this subsection. */
    virtual std::string
    subsection() const
    {
      return name();
    }

    /** All parameters, stiffnesses first. */
    std::vector<FitVariable>
    variables() const
    {
      std::vector<FitVariable> all = stiffnesses;
      all.insert(all.end(), shapes.begin(), shapes.end());
      return all;
    }
  };

  /** The model of the material of this name with default bounds: HGO, Fung
   * (planar, without shear), Ogden of order @p ogden_order with the convention
   * Abaqus, or May-Newman-Yin. */
  std::unique_ptr<TissueModel>
  make_tissue_model(const std::string &name, const unsigned int ogden_order);
} // namespace coapt

#endif
