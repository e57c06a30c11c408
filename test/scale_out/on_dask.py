# SPDX-License-Identifier: GPL-3.0-or-later
"""on_dask.py PROGRAM EXAMPLES: a collection on a LocalCluster, of whose two workers one is killed."""

import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time

try:
    import distributed
except ImportError:
    print("SKIPPED: dask.distributed is not installed (python3-distributed)")
    sys.exit(77)

NUMBER = 8
OPTIONS = ["--quads", "200", "--effort", "fast"]


def record_times(results):
    times = {}
    for folder, _, files in os.walk(os.path.join(results, "meshes")):
        if "record.json" in files:
            file = os.path.join(folder, "record.json")
            times[file] = os.stat(file).st_mtime_ns
    return times


def main(program, examples):
    sys.path.insert(0, examples)
    import reebquad_dask

    work = tempfile.mkdtemp(prefix="reebquad-scale-")
    meshes, results = os.path.join(work, "in"), os.path.join(work, "out")
    os.mkdir(meshes)
    for i in range(NUMBER):
        subprocess.run([program, "shape", "genus-2", "--triangles", str(3000 + 100 * i), "-o",
                        os.path.join(meshes, f"{i}.off")], check=True)
    try:
        with distributed.LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None,
                                      local_directory=work) as cluster, distributed.Client(cluster) as client:
            workers = client.run(os.getpid)
            futures = reebquad_dask.map_meshes(client, meshes, results, OPTIONS, program)
            deadline = time.monotonic() + 60
            while not record_times(results):
                assert time.monotonic() < deadline, "no mesh was done in a minute"
                time.sleep(0.05)
            early = record_times(results)
            os.kill(next(iter(workers.values())), signal.SIGKILL)
            records = [future.result() for future in futures]
        late = record_times(results)
        assert sorted(r["name"] for r in records) == [f"in/{i}.off" for i in range(NUMBER)], records
        assert all(r["outcome"] == "certified" for r in records), records
        assert len(late) == NUMBER and all(late[file] == t for file, t in early.items()), "a mesh was done twice"
        assert reebquad_dask.pending(meshes, results, OPTIONS, program) == []
        print(f"{NUMBER} meshes, each done once; {len(early)} were done before a worker was killed")
    finally:
        shutil.rmtree(work, ignore_errors=True)


if __name__ == "__main__":
    main(os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2]))
