"""The fuzzer finds faults that are planted, reports nothing else, and changes files as it says."""

import itertools
import json
import struct
import sys
import zlib
from random import Random

import pytest

import planted_faults
from fuzz.__main__ import main
from fuzz.campaign import Campaign
from fuzz.case import Case, Limits
from fuzz.findings import Findings, read_finding
from fuzz.mutations import LARGEST_CASE, MUTATORS, mutated
from fuzz.seeds import companions, honest_files
from fuzz.targets import TARGETS
from fuzz.worker import Worker

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="the fuzzer needs POSIX signals")
ROUNDS = 1
"""Cases of every planted fault."""


def planted_campaign(folder, seed=0, only=()):
    return Campaign(
        folder / "work",
        Findings(folder / "findings"),
        {"obj": [planted_faults.HONEST]},
        {"obj": {"beside.txt": b"x"}},
        seed=seed,
        module="planted_faults",
        only=only,
        limits=Limits(seconds=0.25),
    )


# -- findings --------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def planted(tmp_path_factory):
    """A campaign of a few cases for every planted fault."""
    campaign = planted_campaign(tmp_path_factory.mktemp("planted"))
    campaign.run(120.0, most=ROUNDS * len(planted_faults.TARGETS))
    return campaign


@pytest.mark.slow
@pytest.mark.parametrize("fault", planted_faults.FAULTS, ids=lambda fault: fault.__name__)
def test_a_planted_fault_is_found(planted, fault):
    name = fault.__name__
    kinds = {f.fault.kind for f in planted.findings.by_key.values() if f.case.target == name}
    assert kinds == {planted_faults.FAULTS[fault]}
    assert planted.tallies[name].findings == ROUNDS


def test_refusals_are_no_findings(planted):
    for run in planted_faults.HARMLESS:
        tally = planted.tallies[run.__name__]
        assert (tally.cases, tally.findings) == (ROUNDS, 0)
        assert sum(tally.errors.values()) == ROUNDS


def test_a_fault_is_written_once_with_its_traceback_and_target(planted):
    files = [file for file in planted.findings.folder.iterdir() if file.suffix == ".obj"]
    assert len(files) == len(planted.findings.by_key)
    cases = {read_finding(file).target: file for file in files}
    text = cases["other_error"].with_suffix(".txt").read_text()
    assert "ValueError at planted_faults.py:" in text
    assert 'raise ValueError(f"{file}: not handled")' in text
    assert "planted_faults.py" in cases["sleep"].with_suffix(".txt").read_text()


def test_a_worker_that_died_is_replaced(planted):
    deaths = ("sleep", "endless_loop", "death", "end")
    assert planted.worker.starts == 1 + sum(planted.tallies[name].findings for name in deaths)


def test_two_runs_of_one_seed_have_the_same_cases(tmp_path):
    names = [run.__name__ for run in planted_faults.HARMLESS]
    runs = []
    for folder, seed in (("a", 7), ("b", 7), ("c", 8)):
        campaign = planted_campaign(tmp_path / folder, seed, names)
        with campaign.worker:
            cases = []
            for case in itertools.islice(campaign.cases(), 30):
                campaign.judge(case)
                cases.append(case.data)
        runs.append(cases)
    assert runs[0] == runs[1] != runs[2]


def test_an_input_with_a_new_error_becomes_a_seed(tmp_path):
    campaign = planted_campaign(tmp_path, only=["refused", "argument"])
    with campaign.worker:
        for data in (b"1", b"22", b"333"):
            campaign.judge(Case("argument", "obj", data))
    # The messages differ in a number only.
    assert campaign._found == {("argument", "obj", True): [b"1"]}


def test_an_honest_file_at_fault_ends_the_run(tmp_path):
    honest = [Case("other_error", "obj", b"not the honest file")]
    worker = Worker(tmp_path / "work", "planted_faults", honest, {}, Limits())
    with pytest.raises(RuntimeError, match=r"honest file of other_error .* ValueError"):
        worker.start()


# -- mutations -------------------------------------------------------------------------------------


@pytest.mark.parametrize("form", MUTATORS)
def test_mutations_change_files_within_the_largest_size(form):
    seeds = honest_files()[form]
    results = {mutated(seeds[0], form, Random(number), seeds) for number in range(100)}
    assert len(results) > 60
    assert max(map(len, results)) <= LARGEST_CASE


def test_most_changed_glb_files_have_right_lengths_and_json():
    seeds = honest_files()["glb"]
    readable = 0
    for number in range(300):
        data = mutated(seeds[0], "glb", Random(number), seeds)
        if len(data) < 20 or struct.unpack_from("<I", data, 8)[0] != len(data):
            continue
        length = struct.unpack_from("<I", data, 12)[0]
        try:
            json.loads(data[20 : 20 + length])
        except ValueError:
            continue
        readable += 1
    assert readable > 180


def test_most_chunks_of_changed_png_files_have_right_checksums():
    seeds = honest_files()["png"]
    right = wrong = 0
    for number in range(300):
        data, position = mutated(seeds[0], "png", Random(number), seeds), 8
        while position + 12 <= len(data):
            length = struct.unpack_from(">I", data, position)[0]
            content = data[position + 4 : position + 8 + length]
            check = data[position + 8 + length : position + 12 + length]
            right += check == struct.pack(">I", zlib.crc32(content))
            wrong += check != struct.pack(">I", zlib.crc32(content))
            position += 12 + length
    assert right > 10 * wrong > 0


# -- targets ---------------------------------------------------------------------------------------


def test_every_format_has_honest_files_mutators_and_a_target():
    used = {form for target in TARGETS.values() for form in target.forms}
    assert used == set(honest_files()) == set(MUTATORS)


@pytest.mark.slow
def test_the_honest_files_are_read_and_their_changes_are_judged(tmp_path):
    seeds = honest_files()
    beside = {form: companions(form) for form in seeds}
    campaign = Campaign(tmp_path / "work", Findings(tmp_path / "findings"), seeds, beside)
    count = sum(target.weight for target in TARGETS.values())
    assert campaign.run(60.0, most=count) == count
    tallies = campaign.tallies.values()
    assert sum(tally.accepted + sum(tally.errors.values()) for tally in tallies) > count // 2


def test_an_unknown_target_is_refused(capsys):
    assert main(["--target", "mesh FBX"]) == 2
    assert "there is no target 'mesh FBX'" in capsys.readouterr().err
