"""Fuzzes for long with all fuzzers of a build of libFuzzer, at idle priority, and adds what it took to a JSON file, that of the report where none is named.

    cmake --preset fuzz && cmake --build --preset fuzz
    python3 tests/fuzz/campaign.py build/fuzz --turn-s 120 --rounds 30

Each fuzzer runs as its test does, but for the time: with its corpus, its words and its limits, of which 30 s per input become 600, since the
clock says little at idle priority. What fails is kept in found/ of the build folder. An end that is no success counts as a fault, and stays
one in the file when it was mended. The build has to be of a commit as it stands; the file says how many CPU seconds each commit got.
"""
import argparse
import json
import os
import re
import subprocess
import threading
from concurrent.futures import ThreadPoolExecutor
from datetime import date
from pathlib import Path


REPORT = Path(__file__).parents[2] / "docs/report/results/fuzz.json"


def fuzzers(build):
    """Command lines by name, as ctest has them."""
    listed = subprocess.run(["ctest", "--test-dir", build, "-L", "^fuzz$", "--show-only=json-v1"], check=True, capture_output=True)
    return {test["name"].removeprefix("fuzz."): test["command"] for test in json.loads(listed.stdout)["tests"]}


def turn(command, seconds, found):
    """What one turn of a fuzzer took."""
    command = ["chrt", "-i", "0", *command, f"-max_total_time={seconds}", "-timeout=600", f"-artifact_prefix={found}"]
    process = subprocess.Popen(command, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True, errors="replace")
    text = process.stderr.read()
    _, status, usage = os.wait4(process.pid, 0)
    executions = re.findall(r"stat::number_of_executed_units: *(\d+)", text)
    edges = re.findall(r"cov: (\d+)", text)
    return {"executions": int(executions[-1]) if executions else 0, "cpu_s": usage.ru_utime + usage.ru_stime,
            "faults": int(status != 0), "edges": int(edges[-1]) if edges else 0}


def commit_of(build):
    """Of the sources that a build folder was made from; they have to be as committed."""
    cache = (Path(build) / "CMakeCache.txt").read_text()
    sources = re.search(r"^CMAKE_HOME_DIRECTORY:INTERNAL=(.*)$", cache, re.MULTILINE)[1]
    git = ["git", "-C", sources]
    if subprocess.run([*git, "status", "--porcelain", "--untracked-files=no"], check=True, capture_output=True).stdout:
        raise SystemExit("commit first: what was fuzzed has to have a name")
    return subprocess.run([*git, "rev-parse", "--short=10", "HEAD"], check=True, capture_output=True, text=True).stdout.strip()


def processor():
    return re.search(r"^model name\s*: (.*)$", Path("/proc/cpuinfo").read_text(), re.MULTILINE)[1]


def add(rows, name, took):
    row = next((row for row in rows if row["file"] == name), None)
    if row is None:
        row = {"file": name, "executions": 0, "cpu_s": 0.0, "faults": 0, "edges": 0}
        rows.append(row)
    for key in ("executions", "cpu_s", "faults"):
        row[key] = row[key] + took[key]
    row["edges"] = max(row["edges"], took["edges"])


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("build")
    arguments.add_argument("json", type=Path, nargs="?", default=REPORT)
    arguments.add_argument("--turn-s", type=int, default=120)
    arguments.add_argument("--rounds", type=int, default=1)
    options = arguments.parse_args()
    commit = commit_of(options.build)
    found = Path(options.build).resolve() / "found"
    found.mkdir(exist_ok=True)
    before = json.loads(options.json.read_text()) if options.json.exists() else {}
    rows, commits = before.get("rows", []), before.get("origin", {}).get("cpu_s_of_commits", {})
    lock = threading.Lock()

    def run(named):
        name, command = named
        took = turn(command, options.turn_s, f"{found}/{name}-")
        with lock:
            add(rows, name, took)
            commits[commit] = commits.get(commit, 0.0) + took["cpu_s"]
            totals = {key: sum(row[key] for row in rows) for key in ("executions", "cpu_s", "faults")}
            origin = {"commit": commit, "processor": processor(), "date": str(date.today()), "cpu_s_of_commits": commits,
                      "command": f"campaign.py build/fuzz --turn-s {options.turn_s}"}
            options.json.write_text(json.dumps({"measure": "fuzz", **totals, "rows": rows, "origin": origin}, indent=2) + "\n")

    with ThreadPoolExecutor(max_workers=2) as two:
        list(two.map(run, list(fuzzers(options.build).items()) * options.rounds))


if __name__ == "__main__":
    main()
