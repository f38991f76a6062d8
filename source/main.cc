#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>

#include <coapt/base/exceptions.h>
#include <coapt/simulation.h>

#include <iostream>

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  coapt::Log                               log(MPI_COMM_WORLD);
  try
    {
      dealii::ParameterHandler    prm;
      coapt::SimulationParameters parameters;
      coapt::SimulationParameters::declare_parameters(prm);
      parameters.read(argv[1], prm);
      coapt::Simulation simulation(parameters, log, MPI_COMM_WORLD);
      simulation.run();
    }
  catch (const std::exception &error)
    {
      log.line(error.what());
      return 1;
    }
  return 0;
}
