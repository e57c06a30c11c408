# SPDX-License-Identifier: GPL-3.0-or-later
"""A collection of meshes on a cluster of Dask: `map_meshes` runs the program reebquad once for each mesh, on any worker.

Needs dask.distributed (Debian: python3-distributed) and, on each worker, the program and the folders of meshes and results. A task
whose worker is lost is given to another one; what has a record is not done again, so that each mesh is done once.

    python3 reebquad_dask.py SCHEDULER MESHES RESULTS [options of run]
"""

import json
import os
import subprocess
import sys

import distributed


def pending(meshes, results, options=(), program="reebquad"):
    """The names of the meshes that have no record of these options, as `reebquad batch --pending` tells them."""
    command = [program, "batch", str(meshes), "-o", str(results), "--pending", "--", *options]
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout.splitlines()


def quadrangulate(name, meshes, results, options=(), program="reebquad", memory=0, seconds=0):
    """Does one mesh, if it is not done yet, and returns its record: a dict with `outcome`, `sentence`, `quads`, ..."""
    command = [program, "batch", str(meshes), "-o", str(results), "--one", name, "--jobs", "1", "--quiet",
               "--memory", str(memory), "--time", str(seconds), "--", *options]
    done = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    if done.returncode not in (0, 6):  # 6: the mesh failed, and the record tells why
        raise RuntimeError(f"{name}: {done.stderr.strip()}")
    with open(os.path.join(results, "meshes", name, "record.json"), encoding="utf-8") as record:
        return json.load(record)


def map_meshes(client, meshes, results, options=(), program="reebquad", memory=0, seconds=0):
    """Futures of the records of all meshes that are not done, as they end (`distributed.as_completed`).

    client   a distributed.Client
    meshes   a folder (or a file) that all workers see
    results  the folder of all results, which they see as well
    options  options of `reebquad run`, for instance ["--quads", "5000"]
    memory   megabytes, and `seconds`, that a mesh may take; 0: no limit
    """
    client.upload_file(os.path.abspath(__file__))  # workers import this module
    names = pending(meshes, results, options, program)
    futures = client.map(quadrangulate, names, meshes=str(meshes), results=str(results), options=list(options),
                         program=program, memory=memory, seconds=seconds, pure=False, retries=3)
    return distributed.as_completed(futures)


def main(arguments):
    if len(arguments) < 3:
        print(__doc__)
        return 2
    scheduler, meshes, results, *options = arguments
    with distributed.Client(scheduler) as client:
        for future in map_meshes(client, meshes, results, options, os.environ.get("REEBQUAD", "reebquad")):
            record = future.result()
            print(record["name"] + ":", record["outcome"], record["sentence"])
    program = os.environ.get("REEBQUAD", "reebquad")
    return subprocess.run([program, "batch", meshes, "-o", results, "--table", "--", *options]).returncode


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
