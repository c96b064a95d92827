"""The library in Chromium: skin.gl.glsl as GLSL ES 3.00 in WebGL 2, skin.wgsl by Tint in WebGPU."""

from __future__ import annotations

import base64
import re
import shutil
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
from glsl_text import VERTEX, fragment_text
from on_wgpu import entry_point
from rows import WGSL, Runner, generated, places, statements, texture_names

from gpu_device import absent
from skinshade.codegen.kernels import WORKGROUP
from skinshade.codegen.signatures import FLOATS, signatures

PROGRAMS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
# Root cannot have a sandbox, and the page shows nothing but this project's shaders; WebGPU is
# behind a flag where the only adapter is software.
FLAGS = ["--no-sandbox", "--enable-unsafe-webgpu"]
ES = """#version 300 es
precision highp float;
precision highp int;
precision highp sampler2D;
"""
KERNEL = """@compute @workgroup_size({group})
fn {entry}(@builtin(global_invocation_id) thread : vec3<u32>)
{{
    let row = thread.x;
{statements}
}}
"""


class Browser:
    """One Chromium for all pages, driven from a thread of its own.

    Whoever drives it has an event loop running in its thread, where nobody else could start one.
    """

    def __init__(self):
        program = next(filter(None, map(shutil.which, PROGRAMS)), None)
        if program is None:
            absent("Chromium is not installed (Debian: chromium)")
        self.thread = ThreadPoolExecutor(1)
        try:
            self.driver, self.browser = self.within(self._started, program)
        except Exception as error:  # no package, or a browser that does not start
            self.thread.shutdown()
            absent(f"Chromium cannot be driven ({error})")

    @staticmethod
    def _started(program):
        from playwright.sync_api import sync_playwright

        driver = sync_playwright().start()
        try:
            return driver, driver.chromium.launch(executable_path=program, args=FLAGS)
        except BaseException:
            driver.stop()
            raise

    def within(self, function, *arguments):
        """Call a function in the browser's thread."""
        return self.thread.submit(function, *arguments).result()

    def page(self, script):
        """Return a page that has run a script; WebGPU wants a secure context, as localhost is."""
        page = self.browser.new_page()
        page.route(
            "**/*", lambda route: route.fulfill(body="<!doctype html>", content_type="text/html")
        )
        page.goto("http://localhost/")
        texts = [Path(__file__).with_name(each).read_text("utf-8") for each in ("page.js", script)]
        page.evaluate("async () => {" + "\n".join(texts) + "}")
        return page

    def close(self):
        self.within(self.browser.close)
        self.within(self.driver.stop)
        self.thread.shutdown()


class Page(Runner):
    """A page whose script defines ``rows``, which runs one function."""

    script: str

    def __init__(self, browser):
        self.browser = browser
        try:
            self.page = browser.within(browser.page, self.script)
        except Exception as error:
            absent(f"{self.script}: {error}")

    def run(self, signature, rows, textures):
        width = FLOATS[signature.returns]
        given = {
            "count": len(rows),
            "length": rows.shape[1],
            "width": width,
            "data": text64(rows),
            "textures": [described(name, each) for name, each in textures.items()],
            **self.program(signature, list(textures)),
        }
        found = self.browser.within(self.page.evaluate, "given => window.rows(given)", given)
        floats = np.frombuffer(base64.b64decode(found), dtype=np.float32)
        return floats.reshape(len(rows), -1)[:, :width]

    def program(self, signature, names):
        """What ``rows`` needs to know besides numbers and textures."""
        raise NotImplementedError

    def close(self):
        self.browser.within(self.page.close)


class WebGL(Page):
    """A draw for each function."""

    script = "webgl.js"

    def program(self, signature, names):
        text = fragment_text(signature, generated("skin.gl.glsl"), names)
        return {"vertex": ES + VERTEX, "fragment": ES + text}


class WebGPU(Page):
    """A dispatch for each function; the kernels stand in one module, as a user would write them."""

    script = "webgpu.js"

    def __init__(self, browser):
        super().__init__(browser)
        self.places = places()
        self.text = self._text(signatures())

    def _text(self, functions):
        globals_ = [
            "var<storage, read> inputs : array<f32>",
            "var<storage, read_write> outputs : array<f32>",
        ]
        for name in texture_names(functions):
            globals_ += [f"var {name} : texture_2d<f32>", f"var {name}_sampler : sampler"]
        lines = [f"@group(0) @binding({at}) {each};" for at, each in enumerate(globals_)]
        kernels = [
            KERNEL.format(
                group=WORKGROUP,
                entry=entry_point(each),
                statements=statements(each, WGSL, index_type="let", result_type="let"),
            )
            for each in functions
        ]
        return "\n".join([*lines, generated("skin.wgsl"), *kernels])

    def program(self, signature, names):
        # The text goes over once; the page keeps the module.
        text, self.text = self.text, None
        entry = entry_point(signature)
        return {"text": text, "entry": entry, "places": self.places, "group": WORKGROUP}


def described(name, texture):
    """A texture as the scripts take it; WebGPU's words for sampling are in camel case there."""
    height, width, _ = texture.rgba.shape
    sampled = {
        re.sub("_(.)", lambda f: f[1].upper(), key): value for key, value in texture.sampled.items()
    }
    return {
        "name": name,
        "width": width,
        "height": height,
        "linear": texture.linear,
        "around": texture.around,
        "sampled": sampled,
        "data": text64(texture.rgba),
    }


def text64(array):
    return base64.b64encode(np.ascontiguousarray(array, dtype=np.float32).tobytes()).decode()
