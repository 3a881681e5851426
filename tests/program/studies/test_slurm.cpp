// A study under Slurm: its daemons run here, on one node, where they are installed.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <string>

#include <catch2/catch.hpp>

#include "tests/program/studies/study_run.hpp"

using namespace hvi::test;

namespace {

/// A star whose rows take some 20 ms each.
const std::string star_of_tasks =
    "hamiltonian = \"(px^2 + py^2)/2 + (x^2 + y^2)/2 + x^2*y - y^3/3\"\n"
    "coordinates = [\"x\", \"y\"]\nmomenta = [\"px\", \"py\"]\n"
    "initial = {x = 0, y = \"1/10\", px = \"1/2\", py = 0}\n"
    "run = {method = \"gauss:4\", step = \"1/4\", until = 8000}\n";

const std::string rows_of_tasks = "--random 'y=normal(0, 1/10)' --samples 400 --chunk 20";

/// Starts the daemons of Slurm in a directory, without privileges, and ends them with the shell.
/// The status is 77 where the node does not come up. NOTE: an interface of the machine is not
/// needed, nor munge; ports are free ones.
const std::string with_slurm = R"sh(
mkdir -p bin slurm/state slurm/spool && ln -sf "$hvi_gen" bin/hvi-gen
export PATH=$PWD/bin:$PATH:/usr/sbin:/sbin SLURM_CONF=$PWD/slurm/slurm.conf
port() { /usr/bin/python3 -c 'import socket; s = socket.socket(); s.bind(("", 0)); print(s.getsockname()[1])'; }
cat > "$SLURM_CONF" <<END
ClusterName=hvi
SlurmctldHost=$(uname -n)(127.0.0.1)
SlurmctldPort=$(port)
SlurmdPort=$(port)
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
AuthType=auth/none
CredType=cred/none
StateSaveLocation=$PWD/slurm/state
SlurmdSpoolDir=$PWD/slurm/spool
SlurmctldPidFile=$PWD/slurm/slurmctld.pid
SlurmdPidFile=$PWD/slurm/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmdParameters=config_overrides
JobAcctGatherType=jobacct_gather/none
SchedulerParameters=sched_interval=1,batch_sched_delay=0
NodeName=$(uname -n) NodeAddr=127.0.0.1 CPUs=4
PartitionName=all Nodes=ALL Default=YES
END
slurmctld -D > slurm/daemons.log 2>&1 & controller=$!
slurmd -D >> slurm/daemons.log 2>&1 & node=$!
queue_ends() { for k in $(seq 300); do [ -z "$(squeue -h)" ] && return; sleep 0.1; done; return 1; }
trap 'scancel --partition=all; queue_ends; kill $node $controller; wait $node $controller' EXIT
until [ "$(sinfo -h -o %T)" = idle ]; do
    [ $SECONDS -lt 60 ] && kill -0 $node $controller || { cat slurm/daemons.log >&2; exit 77; }
    sleep 0.1
done
submit() { timeout 120 sbatch --time=5 --output=slurm/said-%a.txt "$@" job.sh; }
)sh";

/// Removes the directory of the study from before, and prints a batch file of four tasks.
const std::string print_batch =
    "rm -rf study && eval \"$study " + rows_of_tasks + " --slurm 4\" > job.sh && ";

}  // namespace

TEST_CASE("rows have the same bits under Slurm, and tasks that are told to end are made up for") {
    if (shell("PATH=$PATH:/usr/sbin:/sbin; command -v slurmctld && command -v slurmd && "
              "command -v sbatch")
            .status != 0) {
        WARN("there is no Slurm: its tasks are not tested");
        return;
    }
    const Directory directory;
    write(directory / "scene.toml", star_of_tasks);
    const std::string sums = "(cd study/chunks && find . -type f | sort | xargs cksum)";
    const Outcome alone = study_in(directory, "eval \"$study " + rows_of_tasks +
                                                  " --workers 1\" && " + sums + " > alone");
    INFO(alone.err);
    REQUIRE(alone.status == 0);

    const std::string all_to_the_end =
        print_batch + "submit --wait >&2; " + sums + " > tasks; cmp alone tasks\n";
    const std::string told_to_end =
        print_batch +
        "job=$(submit --parsable)\n"
        "for k in $(seq 600); do\n"
        "  [ $(ls study/chunks/000 2> /dev/null | grep -c lock) = 4 ] && break; sleep 0.05\n"
        "done\n"
        "scancel --batch --signal=USR1 $job; queue_ends\n"
        "scontrol show job $job | grep -o 'ExitCode=[0-9:]*'\n"
        "ls study/chunks/000 | sed 's/.*[.]//' | sort -u | grep -v npy\n"
        "submit --wait >&2; " +
        sums + " > again; cmp alone again\n";
    const Outcome outcome =
        study_in(directory, with_slurm + "set -e\n" + all_to_the_end + told_to_end);
    if (outcome.status == 77) {
        WARN("Slurm does not run here, and its tasks are not tested: " << outcome.err);
        return;
    }
    INFO(outcome.err);
    CHECK(outcome.status == 0);
    CHECK(outcome.out == "ExitCode=130:0\nExitCode=130:0\nExitCode=130:0\nExitCode=130:0\n"
                         "part\n");
}
