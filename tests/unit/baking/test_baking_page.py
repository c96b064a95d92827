"""The HTML report in Chromium: images load, nothing is wider than the window, and the filter works."""

import json
import os
import shutil
import subprocess
import sys
import textwrap

import pytest
from test_baking_plan import SETTINGS, write_asset

from gpu_device import absent
from skinshade.baking.jobs import plan_jobs, run_job
from skinshade.baking.report import write_page

PROGRAMS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
NAMES = [
    "plain.glb",
    "with space.glb",
    "quo'te.glb",
    "100%25 #hash.glb",
    "頭部.glb",
    "x" * 180 + ".glb",
]
UNIX_NAMES = [
    "<img src=x onerror=alert(1)>.glb",
    'double"quote.glb',
    "new\nline.glb",
    "what?q=1.glb",
    "back\\slash.glb",
    "javascript:alert(1).glb",
    "rtl\u202egpj.glb",
    os.fsdecode(b"latin\xe9.glb"),
]
"""Names that Windows does not allow."""
# The driver runs in a process of its own, because its event loop would stay in the process of the tests.
SCRIPT = textwrap.dedent("""
    import json, sys
    from playwright.sync_api import sync_playwright
    program, address = sys.argv[1:]
    measured = {}
    with sync_playwright() as driver:
        browser = driver.chromium.launch(executable_path=program, args=["--no-sandbox"])
        page = browser.new_page(viewport={"width": 390, "height": 800})
        messages, requests = [], []
        page.on("console", lambda message: messages.append(message.text))
        page.on("pageerror", lambda error: messages.append(str(error)))
        page.on("dialog", lambda dialog: (messages.append(dialog.message), dialog.dismiss()))
        page.on("request", lambda request: requests.append(request.url))
        page.goto(address)
        measured["widths"] = page.evaluate("[document.documentElement.scrollWidth, innerWidth]")
        measured["images"] = page.evaluate('''async () => {
            const images = [...document.images];
            for (const image of images) {
                image.loading = "eager";
                await image.decode().catch(() => 0);
            }
            return images.map(image => image.naturalWidth);
        }''')
        visible = '''[...document.querySelectorAll("article, li")]
            .filter(item => item.checkVisibility()).map(item => item.textContent)'''
        measured["all"] = page.evaluate(visible)
        for text in ("PLAIN", "failed empty", "nothing has this text"):
            page.fill("input", text)
            measured[text] = page.evaluate(visible)
        measured["counter"] = page.text_content("output")
        measured["headings"] = page.evaluate(
            '[...document.querySelectorAll("h2")].filter(h => h.checkVisibility()).length')
        measured["colours"] = []
        for scheme in ("light", "dark"):
            page.emulate_media(color_scheme=scheme)
            measured["colours"].append(page.evaluate("getComputedStyle(document.body).backgroundColor"))
        page.evaluate('''() => {
            const script = document.createElement("script");
            script.textContent = "document.title = 'changed'";
            document.body.append(script);
        }''')
        measured["title"] = page.title()
        measured["messages"], measured["requests"] = messages, requests
        browser.close()
    print(json.dumps(measured))
""")


@pytest.fixture(scope="module")
def measured(tmp_path_factory):
    """Measurements of the page of a library whose names are hard to write and to link."""
    program = next(filter(None, map(shutil.which, PROGRAMS)), None)
    if program is None:
        absent("Chromium is not installed (Debian: chromium)")
    pytest.importorskip("playwright", reason="playwright is not installed")
    folder = tmp_path_factory.mktemp("page")
    source = write_asset(folder / "source.glb")
    (folder / "in").mkdir()
    for name in (*NAMES, *(UNIX_NAMES if sys.platform == "linux" else ())):
        shutil.copy(source, folder / "in" / name)
    for name in ("empty.glb", "void.glb"):
        (folder / "in" / name).touch()
    jobs = plan_jobs([folder / "in"], folder / "out", SETTINGS, with_thumbnails=True)
    page = folder / "out" / "page.html"
    write_page(jobs, [run_job(job) for job in jobs], page)
    done = subprocess.run(
        [sys.executable, "-c", SCRIPT, program, page.as_uri()],
        capture_output=True,
        text=True,
        timeout=100,
        check=False,
    )
    if "BrowserType.launch" in done.stderr:
        absent(f"Chromium cannot be driven ({done.stderr[-500:]})")
    assert done.returncode == 0, done.stderr
    return len(jobs), json.loads(done.stdout)


@pytest.mark.slow
def test_every_thumbnail_loads_whatever_the_name_of_its_asset(measured):
    count, values = measured
    assert values["images"] == [2 * 192] * (count - 2)


@pytest.mark.slow
def test_the_page_fits_into_a_window_of_390_pixels(measured):
    assert measured[1]["widths"] == [390, 390]


@pytest.mark.slow
def test_the_page_runs_no_script_of_a_name_and_loads_only_local_files(measured):
    _, values = measured
    assert [url for url in values["requests"] if not url.startswith("file:///")] == []
    assert values["title"] == "skinshade bake", "the policy of the page refuses added scripts"
    assert [text for text in values["messages"] if "Content Security Policy" not in text] == []


@pytest.mark.slow
def test_the_filter_hides_assets_and_failures_without_all_its_words(measured):
    count, values = measured
    assert len(values["all"]) == count
    (plain,) = values["PLAIN"]
    assert plain.startswith("plain.glb")
    assert values["failed empty"] == ["empty.glb", "void.glb"]
    assert values["nothing has this text"] == []
    assert (values["counter"], values["headings"]) == (f"0 of {count}", 0)


@pytest.mark.slow
def test_the_page_is_dark_where_the_system_is(measured):
    light, dark = measured[1]["colours"]
    assert (light, dark) == ("rgb(251, 250, 248)", "rgb(27, 26, 25)")
