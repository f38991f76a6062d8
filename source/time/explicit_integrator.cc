#include <arkode/arkode_erkstep.h>
#include <coapt/base/exceptions.h>
#include <coapt/time/explicit_integrator.h>

#include <algorithm>
#include <string>

namespace coapt
{
  namespace
  {
    void
    check_flag(const int flag,
               const std::string &call,
               const std::string &reason = "")
    {
      if (flag < 0)
        throw NumericalError("SUNDIALS: " + call + " failed with code " +
                             std::to_string(flag) +
                             (reason.empty() ? "" : ": " + reason));
    }



    /** Terms of a linear combination of arrays, without those of coefficient
     * zero, of which the table has many. */
    template <unsigned int n_terms>
    void
    combine(const long n,
            const double *coefficients,
            const double *const *terms,
            double *result)
    {
      double c[n_terms];
      const double *x[n_terms];
      std::copy_n(coefficients, n_terms, c);
      std::copy_n(terms, n_terms, x);
#pragma GCC ivdep // the result may be one of the terms, at the same place
      for (long i = 0; i < n; ++i)
        {
          double sum = c[0] * x[0][i];
          for (unsigned int k = 1; k < n_terms; ++k)
            sum += c[k] * x[k][i];
          result[i] = sum;
        }
    }



    /** Replaces SUNDIALS' linear combination of vectors, which took longer
     * than the right-hand side of the fluid. */
    int
    linear_combination(int n_vectors,
                       realtype *coefficients,
                       N_Vector *vectors,
                       N_Vector result)
    {
      constexpr int max_terms = 8;
      double c[max_terms];
      const double *terms[max_terms];
      int n_terms = 0;
      for (int k = 0; k < n_vectors; ++k)
        if (coefficients[k] != 0)
          {
            if (n_terms == max_terms)
              return N_VLinearCombination_Parallel(n_vectors,
                                                   coefficients,
                                                   vectors,
                                                   result);
            c[n_terms]       = coefficients[k];
            terms[n_terms++] = NV_DATA_P(vectors[k]);
          }
      const long n = NV_LOCLENGTH_P(result);
      switch (n_terms)
        {
          case 1:
            combine<1>(n, c, terms, NV_DATA_P(result));
            return 0;
          case 2:
            combine<2>(n, c, terms, NV_DATA_P(result));
            return 0;
          case 3:
            combine<3>(n, c, terms, NV_DATA_P(result));
            return 0;
          default:
            return N_VLinearCombination_Parallel(n_vectors,
                                                 coefficients,
                                                 vectors,
                                                 result);
        }
    }



    /** Replaces SUNDIALS' z = c x, which Debian compiles without
     * optimisation. */
    void
    scale(realtype c, N_Vector x, N_Vector z)
    {
      const double *from = NV_DATA_P(x);
      const long n       = NV_LOCLENGTH_P(x);
      if (c == 1)
        std::copy_n(from, n, NV_DATA_P(z));
      else
        combine<1>(n, &c, &from, NV_DATA_P(z));
    }



    /** The caller sets the steps, so nothing depends on error weights and
     * norms, which would cost as much as a stage. @{ */
    int
    no_weights(N_Vector, N_Vector, void *)
    {
      return 0;
    }

    realtype
    no_norm(N_Vector, N_Vector)
    {
      return 0;
    }
    /** @} */



    /** Kinnmark and Gray (1984), five stages, third order. */
    ARKodeButcherTable
    kinnmark_gray_table()
    {
      double A[25] = {};
      A[5 * 1 + 0] = 1. / 5;
      A[5 * 2 + 1] = 1. / 5;
      A[5 * 3 + 2] = 1. / 3;
      A[5 * 4 + 3] = 2. / 3;
      double c[5]  = {0, 1. / 5, 1. / 5, 1. / 3, 2. / 3};
      double b[5]  = {1. / 4, 0, 0, 0, 3. / 4};
      return ARKodeButcherTable_Create(5, 3, 0, c, A, b, nullptr);
    }
  } // namespace



  ExplicitIntegrator::ExplicitIntegrator(MPI_Comm communicator,
                                         const RightHandSide &right_hand_side,
                                         const PostStep &post_step)
    : communicator(communicator)
    , right_hand_side(right_hand_side)
    , post_step(post_step)
  {
    check_flag(SUNContext_Create(&this->communicator, &context),
               "SUNContext_Create");
  }



  ExplicitIntegrator::~ExplicitIntegrator()
  {
    release();
    SUNContext_Free(&context);
  }



  void
  ExplicitIntegrator::release()
  {
    if (memory)
      ERKStepFree(&memory);
    if (vector)
      N_VDestroy(vector);
    memory = nullptr;
    vector = nullptr;
  }



  void
  ExplicitIntegrator::start(const double t, std::vector<double> &y)
  {
    release();
    long int local               = y.size();
    long long int total          = 0;
    const long long int local_ll = local;
    MPI_Allreduce(
      &local_ll, &total, 1, MPI_LONG_LONG_INT, MPI_SUM, communicator);
    vector = N_VMake_Parallel(communicator, local, total, y.data(), context);
    check_flag(N_VEnableFusedOps_Parallel(vector, SUNTRUE),
               "N_VEnableFusedOps_Parallel");
    vector->ops->nvlinearcombination = &linear_combination;
    vector->ops->nvscale             = &scale;
    vector->ops->nvwrmsnorm          = &no_norm;
    memory = ERKStepCreate(&ExplicitIntegrator::evaluate, t, vector, context);
    check_flag(memory ? 0 : -1, "ERKStepCreate");

    check_flag(ERKStepSetErrHandlerFn(memory,
                                      &ExplicitIntegrator::keep_message,
                                      this),
               "ERKStepSetErrHandlerFn");

    const ARKodeButcherTable table = kinnmark_gray_table();
    check_flag(ERKStepSetTable(memory, table), "ERKStepSetTable");
    ARKodeButcherTable_Free(table);
    check_flag(ERKStepSetUserData(memory, this), "ERKStepSetUserData");
    check_flag(ERKStepWFtolerances(memory, &no_weights), "ERKStepWFtolerances");
    check_flag(ERKStepSetPostprocessStepFn(memory,
                                           &ExplicitIntegrator::post_process),
               "ERKStepSetPostprocessStepFn");
    // The default interpolant costs an evaluation; nothing is interpolated.
    check_flag(ERKStepSetInterpolantType(memory, ARK_INTERP_LAGRANGE),
               "ERKStepSetInterpolantType");
    check_flag(ERKStepSetInterpolantDegree(memory, 0),
               "ERKStepSetInterpolantDegree");
    current_time = t;
  }



  void
  ExplicitIntegrator::step(const double dt)
  {
    check_flag(ERKStepSetFixedStep(memory, dt), "ERKStepSetFixedStep");
    realtype reached = current_time;
    const int flag =
      ERKStepEvolve(memory, current_time + dt, vector, &reached, ARK_ONE_STEP);
    if (error)
      {
        const std::exception_ptr pending = error;
        error                            = nullptr;
        std::rethrow_exception(pending);
      }
    check_flag(flag, "ERKStepEvolve", message);
    if (!(reached > current_time))
      throw NumericalError("SUNDIALS made no progress at t = " +
                           std::to_string(current_time) + " s");
    current_time = reached;
    ++steps;
  }



  void
  ExplicitIntegrator::keep_message(int,
                                   const char *,
                                   const char *,
                                   char *message,
                                   void *self)
  {
    static_cast<ExplicitIntegrator *>(self)->message = message;
  }



  int
  ExplicitIntegrator::evaluate(realtype t,
                               N_Vector y,
                               N_Vector y_dot,
                               void *self)
  {
    ExplicitIntegrator &integrator = *static_cast<ExplicitIntegrator *>(self);
    ++integrator.evaluations;
    try
      {
        integrator.right_hand_side(t, NV_DATA_P(y), NV_DATA_P(y_dot));
      }
    catch (...)
      {
        // No exception may pass through the C library.
        integrator.error = std::current_exception();
        return -1;
      }
    return 0;
  }



  int
  ExplicitIntegrator::post_process(realtype t, N_Vector y, void *self)
  {
    ExplicitIntegrator &integrator = *static_cast<ExplicitIntegrator *>(self);
    try
      {
        integrator.post_step(t, NV_DATA_P(y));
      }
    catch (...)
      {
        integrator.error = std::current_exception();
        return -1;
      }
    return 0;
  }
} // namespace coapt
