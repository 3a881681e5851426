// Calls of MPI for hvi-gen, compiled by the MPI of this machine.
// SPDX-License-Identifier: MIT
// NOTE: interfaces of MPI for C++ that are no part of it any more.
#define OMPI_SKIP_MPICXX 1
#define MPICH_SKIP_MPICXX 1
#include <mpi.h>

#include <driver/mpi_functions.hpp>

namespace {

MPI_Request meeting = MPI_REQUEST_NULL;

void start(int* rank, int* ranks) {
    int level = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &level);
    MPI_Comm_rank(MPI_COMM_WORLD, rank);
    MPI_Comm_size(MPI_COMM_WORLD, ranks);
}

void send(int to, std::int64_t number) { MPI_Send(&number, 1, MPI_INT64_T, to, 0, MPI_COMM_WORLD); }

int receive(std::int64_t* number) {
    int has_come = 0;
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, 0, MPI_COMM_WORLD, &has_come, &status);
    if (has_come == 0) { return -1; }
    const int from = status.MPI_SOURCE;
    MPI_Recv(number, 1, MPI_INT64_T, from, 0, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    return from;
}

void begin_to_meet() { MPI_Ibarrier(MPI_COMM_WORLD, &meeting); }

bool have_met() {
    int is_done = 0;
    MPI_Test(&meeting, &is_done, MPI_STATUS_IGNORE);
    return is_done != 0;
}

void end() { MPI_Finalize(); }

void abort(int status) { MPI_Abort(MPI_COMM_WORLD, status); }

}  // namespace

extern "C" const hvi::driver::MpiFunctions hvi_mpi_functions;
const hvi::driver::MpiFunctions hvi_mpi_functions{start,    send, receive, begin_to_meet,
                                                  have_met, end,  abort};
