# Read by ctest: Open MPI neither starts as root, nor more ranks than there are
# cores, and binds two tests to the same core, unless it is told otherwise. A
# rank that waits would keep the core from the one that it waits for.
set(ENV{OMPI_ALLOW_RUN_AS_ROOT} 1)
set(ENV{OMPI_ALLOW_RUN_AS_ROOT_CONFIRM} 1)
set(ENV{OMPI_MCA_hwloc_base_binding_policy} none)
set(ENV{OMPI_MCA_rmaps_base_oversubscribe} 1)
set(ENV{OMPI_MCA_mpi_yield_when_idle} 1)
