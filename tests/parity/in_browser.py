"""The library in Chromium: skin.gl.glsl as GLSL ES 3.00 in WebGL 2, and skin.wgsl in WebGPU (Tint)."""

from __future__ import annotations

import base64
import re
import shutil
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
from glsl_text import VERTEX, fragment_text
from on_wgpu import entry_point
from rows import WGSL, Runner, binding_numbers, generated, statements, texture_names

from codegen.kernels import WORKGROUP
from codegen.signatures import FLOATS, signatures
from gpu_device import absent

PROGRAMS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
# The sandbox does not work as root, and the page runs nothing but this project's shaders. WebGPU needs
# a flag where the only adapter is software.
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
    """One Chromium for all pages, driven from its own thread.

    The driver runs an event loop in its thread; no other code could start one in the same thread.
    """

    def __init__(self):
        program = next(filter(None, map(shutil.which, PROGRAMS)), None)
        if program is None:
            absent("Chromium is not installed (Debian: chromium)")
        self.thread = ThreadPoolExecutor(1)
        try:
            self.driver, self.browser = self.within(self._start, program)
        except Exception as error:  # the package is missing, or the browser does not start
            self.thread.shutdown()
            absent(f"Chromium cannot be driven ({error})")

    @staticmethod
    def _start(program):
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
        """Return a page that has run a script; WebGPU needs a secure context, such as localhost."""
        page = self.browser.new_page()
        page.route(
            "**/*", lambda route: route.fulfill(body="<!doctype html>", content_type="text/html")
        )
        page.goto("http://localhost/")
        texts = [Path(__file__).with_name(name).read_text("utf-8") for name in ("page.js", script)]
        page.evaluate("async () => {" + "\n".join(texts) + "}")
        return page

    def close(self):
        self.within(self.browser.close)
        self.within(self.driver.stop)
        self.thread.shutdown()


class Page(Runner):
    """A page whose script defines ``window.rows``, which runs one function."""

    script: str

    def __init__(self, browser):
        self.browser = browser
        try:
            self.page = browser.within(browser.page, self.script)
        except Exception as error:
            absent(f"{self.script}: {error}")

    def run(self, signature, rows, textures):
        width = FLOATS[signature.returns]
        arguments = {
            "count": len(rows),
            "length": rows.shape[1],
            "width": width,
            "data": base64_text(rows),
            "textures": [texture_argument(name, value) for name, value in textures.items()],
            **self.program(signature, list(textures)),
        }
        evaluate = self.page.evaluate
        text = self.browser.within(evaluate, "arguments => window.rows(arguments)", arguments)
        floats = np.frombuffer(base64.b64decode(text), dtype=np.float32)
        return floats.reshape(len(rows), -1)[:, :width]

    def program(self, signature, names):
        """Return the arguments of ``rows`` that describe the program."""
        raise NotImplementedError

    def close(self):
        self.browser.within(self.page.close)


class WebGL(Page):
    """One draw call for each function."""

    script = "webgl.js"

    def program(self, signature, names):
        text = fragment_text(signature, generated("skin.gl.glsl"), names)
        return {"vertex": ES + VERTEX, "fragment": ES + text}


class WebGPU(Page):
    """One dispatch for each function; all kernels and the library are one module, as a user's would be."""

    script = "webgpu.js"

    def __init__(self, browser):
        super().__init__(browser)
        self.bindings = binding_numbers()
        self.text = self._text(signatures())

    def _text(self, functions):
        variables = [
            "var<storage, read> inputs : array<f32>",
            "var<storage, read_write> outputs : array<f32>",
        ]
        for name in texture_names(functions):
            variables += [f"var {name} : texture_2d<f32>", f"var {name}_sampler : sampler"]
        lines = [f"@group(0) @binding({number}) {v};" for number, v in enumerate(variables)]
        kernels = [
            KERNEL.format(
                group=WORKGROUP,
                entry=entry_point(function),
                statements=statements(function, WGSL, index_type="let", result_type="let"),
            )
            for function in functions
        ]
        return "\n".join([*lines, generated("skin.wgsl"), *kernels])

    def program(self, signature, names):
        # The text is sent once; the page keeps the module.
        text, self.text = self.text, None
        entry = entry_point(signature)
        return {"text": text, "entry": entry, "bindings": self.bindings, "group": WORKGROUP}


def texture_argument(name, texture):
    """Return a texture as an argument of the scripts; JavaScript's WebGPU has names in camel case."""
    height, width, _ = texture.rgba.shape
    sampler = {
        re.sub("_(.)", lambda m: m[1].upper(), key): value for key, value in texture.sampler.items()
    }
    return {
        "name": name,
        "width": width,
        "height": height,
        "linear": texture.linear,
        "repeatsU": texture.repeats_u,
        "sampler": sampler,
        "data": base64_text(texture.rgba),
    }


def base64_text(array):
    return base64.b64encode(np.ascontiguousarray(array, dtype=np.float32).tobytes()).decode()
