#include <coapt/base/exceptions.h>
#include <coapt/laboratory/tissue_model.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace coapt
{
  namespace
  {
    /** A limit that is never reached. */
    constexpr double unlimited = 1e300;

    std::string
    text(const double value)
    {
      std::ostringstream stream;
      stream.precision(10);
      stream << value;
      return stream.str();
    }

    std::string
    list(const std::vector<double> &values)
    {
      std::string result;
      for (const double value : values)
        result += (result.empty() ? "" : ", ") + text(value);
      return result;
    }

    class HolzapfelGasserOgdenModel : public TissueModel
    {
    public:
      HolzapfelGasserOgdenModel()
      {
        // A run needs some matrix.
        stiffnesses = {{"C10", "Pa", 100, 1e12, false},
                       {"K1", "Pa", 0, 1e12, false}};
        shapes      = {{"K2", "-", 1e-2, 1000, true},
                       {"kappa", "-", 0, 1. / 3, false}};
      }

      std::string
      name() const override
      {
        return HolzapfelGasserOgden::name;
      }

      std::string
      subsection() const override
      {
        return "Holzapfel-Gasser-Ogden";
      }

      Material
      material(const std::vector<double> &stiffness,
               const std::vector<double> &shape) const override
      {
        HolzapfelGasserOgden law;
        law.C10               = stiffness[0];
        law.K1                = stiffness[1];
        law.K2                = shape[0];
        law.kappa             = shape[1];
        law.exponential_limit = unlimited;
        return law;
      }

      std::vector<std::pair<std::string, std::string>>
      entries(const std::vector<double> &stiffness,
              const std::vector<double> &shape,
              const double limit) const override
      {
        return {{"C10", text(stiffness[0])},
                {"K1", text(stiffness[1])},
                {"K2", text(shape[0])},
                {"Dispersion", text(shape[1])},
                {"Bulk factor", text(std::max(200., 4.5e5 / stiffness[0]))},
                {"Exponential limit", text(limit)}};
      }
    };

    /** Without shear strain, the constants of the normal strains count; the
     * coupling keeps b1122 below the geometric mean of the others, which makes
     * the energy positive. */
    class FungModel : public TissueModel
    {
    public:
      FungModel()
      {
        stiffnesses = {{"c", "Pa", 0, 1e12, false}};
        shapes      = {{"b1111", "-", 1e-2, 500, true},
                       {"b2222", "-", 1e-2, 500, true},
                       {"coupling", "-", -1, 1, false}};
      }

      std::string
      name() const override
      {
        return Fung::name;
      }

      Material
      material(const std::vector<double> &stiffness,
               const std::vector<double> &shape) const override
      {
        Fung law;
        law.c                 = stiffness[0];
        law.b                 = constants(shape);
        law.exponential_limit = unlimited;
        return law;
      }

      std::vector<std::pair<std::string, std::string>>
      entries(const std::vector<double> &stiffness,
              const std::vector<double> &shape,
              const double limit) const override
      {
        return {{"c", text(stiffness[0])},
                {"b", list(constants(shape))},
                {"Exponential limit", text(limit)}};
      }

    private:
      /** The test says nothing about shear: b1212 as of an isotropic b in the
       * mean, (b1111 + b2222)/4 - b1122/2. */
      static std::vector<double>
      constants(const std::vector<double> &shape)
      {
        const double b12 = shape[2] * std::sqrt(shape[0] * shape[1]);
        return {
          shape[0], b12, 0, shape[1], 0, (shape[0] + shape[1]) / 4 - b12 / 2};
      }
    };

    class OgdenModel : public TissueModel
    {
    public:
      explicit OgdenModel(const unsigned int order)
      {
        for (unsigned int i = 0; i < order; ++i)
          {
            const std::string number = std::to_string(i + 1);
            stiffnesses.push_back({"mu" + number, "Pa", 0, 1e12, false});
            shapes.push_back({"alpha" + number, "-", -80, 80, false});
          }
      }

      std::string
      name() const override
      {
        return Ogden::name;
      }

      Material
      material(const std::vector<double> &stiffness,
               const std::vector<double> &shape) const override
      {
        Ogden law;
        law.mu    = stiffness;
        law.alpha = shape;
        return law;
      }

      std::vector<std::pair<std::string, std::string>>
      entries(const std::vector<double> &stiffness,
              const std::vector<double> &shape,
              const double) const override
      {
        return {{"Convention", "Abaqus"},
                {"Mu", list(stiffness)},
                {"Alpha", list(shape)}};
      }
    };

    class MayNewmanYinModel : public TissueModel
    {
    public:
      MayNewmanYinModel()
      {
        stiffnesses = {{"c0", "Pa", 0, 1e12, false}};
        shapes = {{"c1", "-", 1e-3, 1e3, true}, {"c2", "-", 1e-3, 1e5, true}};
      }

      std::string
      name() const override
      {
        return MayNewmanYin::name;
      }

      Material
      material(const std::vector<double> &stiffness,
               const std::vector<double> &shape) const override
      {
        MayNewmanYin law;
        law.c0                = stiffness[0];
        law.c1                = shape[0];
        law.c2                = shape[1];
        law.exponential_limit = unlimited;
        return law;
      }

      std::vector<std::pair<std::string, std::string>>
      entries(const std::vector<double> &stiffness,
              const std::vector<double> &shape,
              const double limit) const override
      {
        return {{"c0", text(stiffness[0])},
                {"c1", text(shape[0])},
                {"c2", text(shape[1])},
                {"Exponential limit", text(limit)}};
      }
    };
  } // namespace

  std::unique_ptr<TissueModel>
  make_tissue_model(const std::string &name, const unsigned int ogden_order)
  {
    if (name == HolzapfelGasserOgden::name)
      return std::make_unique<HolzapfelGasserOgdenModel>();
    if (name == Fung::name)
      return std::make_unique<FungModel>();
    if (name == Ogden::name)
      return std::make_unique<OgdenModel>(ogden_order);
    if (name == MayNewmanYin::name)
      return std::make_unique<MayNewmanYinModel>();
    throw InputError("Material " + name +
                     " cannot be fitted; there are HGO, Fung, Ogden and "
                     "May-Newman-Yin");
  }
} // namespace coapt
