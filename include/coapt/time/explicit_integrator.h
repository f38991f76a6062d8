#ifndef coapt_time_explicit_integrator_h
#define coapt_time_explicit_integrator_h

#include <mpi.h>
#include <nvector/nvector_parallel.h>

#include <exception>
#include <functional>
#include <string>
#include <vector>

namespace coapt
{
  /**
   * Explicit Runge-Kutta steps by SUNDIALS ARKode (ERKStep) with the
   * Kinnmark-Gray 5(3) table: five stages, stable up to omega dt = 3.87 on the
   * imaginary axis. The caller sets the length of every step.
   */
  class ExplicitIntegrator
  {
  public:
    /** y' = f(t, y) on this rank's array. */
    using RightHandSide =
      std::function<void(double t, const double *y, double *y_dot)>;

    /** Acts on the completed step; the next step starts from what it
     * leaves. */
    using PostStep = std::function<void(double t, double *y)>;

    ExplicitIntegrator(MPI_Comm communicator,
                       const RightHandSide &right_hand_side,
                       const PostStep &post_step);

    ~ExplicitIntegrator();

    ExplicitIntegrator(const ExplicitIntegrator &) = delete;
    ExplicitIntegrator &
    operator=(const ExplicitIntegrator &) = delete;

    /**
     * Starts from the state @p y at time @p t. Due at first and whenever the
     * length or the contents of @p y have changed from outside. @p y is
     * written by every step() and must outlive it.
     */
    void
    start(const double t, std::vector<double> &y);

    /**
     * One step of length @p dt (s). Exceptions of the right-hand side pass
     * through; a failure of SUNDIALS throws NumericalError.
     */
    void
    step(const double dt);

    /** Time reached (s). */
    double
    time() const
    {
      return current_time;
    }

    /** Saves or restores the numbers of steps and evaluations; start() sets the
     * time. */
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &steps &evaluations;
    }

    /** Number of steps so far. */
    unsigned long
    n_steps() const
    {
      return steps;
    }

    /** Number of evaluations of the right-hand side so far. */
    unsigned long
    n_evaluations() const
    {
      return evaluations;
    }

  private:
    static int
    evaluate(realtype t, N_Vector y, N_Vector y_dot, void *self);

    static int
    post_process(realtype t, N_Vector y, void *self);

    /** Keeps what SUNDIALS has to say for the exception that follows, instead
     * of letting it write to the terminal. */
    static void
    keep_message(int code,
                 const char *module,
                 const char *function,
                 char *message,
                 void *self);

    void
    release();

    MPI_Comm communicator;
    RightHandSide right_hand_side;
    PostStep post_step;
    SUNContext context = nullptr;
    void *memory       = nullptr;
    N_Vector vector    = nullptr;
    std::exception_ptr error;
    std::string message;
    double current_time       = 0;
    unsigned long steps       = 0;
    unsigned long evaluations = 0;
  };
} // namespace coapt

#endif
