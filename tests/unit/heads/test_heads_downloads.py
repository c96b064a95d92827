import hashlib
from pathlib import Path

import pooch
import pytest

from skinshade._core.errors import ArgumentError, DownloadError
from skinshade.heads import SCANS, downloads, fetch_scan
from skinshade.heads.downloads import Scan

CONTENT = b"the file with the hash"


@pytest.fixture
def site(monkeypatch, tmp_path):
    """Folder that stands for the server of the scan ``test``, which has one file, ``a.glb``."""
    sha256 = {"a.glb": hashlib.sha256(CONTENT).hexdigest()}
    scan = Scan("https://example.invalid/", sha256, "x", 1.0)
    monkeypatch.setattr(downloads, "SCANS", {"test": scan})
    folder = tmp_path / "site"
    folder.mkdir()
    return folder


@pytest.fixture
def requests(monkeypatch, site):
    """Addresses that were requested; every request is answered from the folder of the site."""
    addresses = []

    def from_folder(url, **_):
        def fetch(url, output, pooch_, **_):
            addresses.append(url)
            Path(output).write_bytes((site / url.rsplit("/", 1)[-1]).read_bytes())

        return fetch

    monkeypatch.setattr(pooch.core, "choose_downloader", from_folder)
    return addresses


def test_a_scan_is_fetched_once(tmp_path, site, requests):
    (site / "a.glb").write_bytes(CONTENT)
    paths = fetch_scan("test", tmp_path / "cache", "https://mirror.invalid/")
    assert paths == [tmp_path / "cache" / "a.glb"]
    assert paths[0].read_bytes() == CONTENT
    assert requests == ["https://mirror.invalid/a.glb"]
    assert fetch_scan("test", tmp_path / "cache") == paths
    assert len(requests) == 1, "a file with the right hash is not requested again"


def test_a_file_with_another_hash_is_refused_and_not_kept(tmp_path, site, requests):
    (site / "a.glb").write_bytes(b"something else")
    with pytest.raises(DownloadError, match=r"a\.glb: the file has another hash than expected"):
        fetch_scan("test", tmp_path / "cache")
    assert len(requests) == 1
    assert list((tmp_path / "cache").iterdir()) == []


def test_a_damaged_copy_is_fetched_again(tmp_path, site, requests):
    (site / "a.glb").write_bytes(CONTENT)
    (tmp_path / "cache").mkdir()
    (tmp_path / "cache" / "a.glb").write_bytes(b"damaged")
    assert fetch_scan("test", tmp_path / "cache")[0].read_bytes() == CONTENT
    assert len(requests) == 1


@pytest.mark.usefixtures("requests")
def test_a_scan_that_cannot_be_reached_is_an_error_that_names_its_address(tmp_path):
    with pytest.raises(DownloadError, match=r"https://example\.invalid/a\.glb: cannot be fetched"):
        fetch_scan("test", tmp_path / "cache")


def test_an_unknown_scan_is_an_error_that_lists_the_known_ones():
    with pytest.raises(ArgumentError, match="there is no scan 'venus'; there are lee-perry-smith"):
        fetch_scan("venus")


@pytest.mark.parametrize("name", SCANS)
def test_every_scan_has_an_address_hashes_and_a_credit(name):
    scan = SCANS[name]
    assert scan.base_url.startswith("https://")
    assert scan.base_url.endswith("/")
    assert all(len(sha256) == 64 for sha256 in scan.sha256.values())
    assert "CC" in scan.credit
    assert scan.unit_mm > 0.0
