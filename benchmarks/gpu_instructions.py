"""Count the cycles of the skin pass on AMD's GPUs by their driver's own estimate; no GPU is needed.

Run by ``make bench``, or as ``python benchmarks/gpu_instructions.py``. It prints a Markdown table. Mesa's
driver can compile for a GPU that is not installed. It estimates the cycles for which a wave keeps a compute
unit busy, as if every branch were taken and no fetch had to wait. The estimate counts arithmetic alone:
neither memory bandwidth nor branches that whole waves skip. It is the same on every machine. The driver
compiles the Slang source, whose hints to unroll loops WGSL lacks: where a driver keeps such a loop, the same
work takes more instructions.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from itertools import product
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))  # the folder of `codegen`

from codegen.compiler import assemble
from skinshade._core.generated import generated_text
from skinshade.gpu.bindings import bind_points, override_ids
from skinshade.params.choices import MaterialMap, Shading, ShadowFilter, Tier, View
from skinshade.params.vertex import VERTEX_VECTORS

FAMILIES = {"RDNA 3": ("GFX1100", "NAVI31"), "RDNA 1": ("NAVI10",), "GCN 5": ("VEGA10",)}
"""Mesa's names of one GPU of each family, older and newer; an unknown name ends the driver's process."""
BASE = {
    "SHADING": Shading.TRANSFER.number,
    "TIER": Tier.DIFFUSED_NORMALS.number,
    "VIEW": View.PICTURE.number,
    "TAPS": 0,
    "LIGHTS": 1,
    "ENVIRONMENT": 1,
    "FETCHES": 3,
    "MULTISAMPLED": 0,
    "MAPS": sum(kind.bit for kind in MaterialMap),
    "SPOT_LIGHTS": 0,
}
"""Constants of the pass that all variants share unless they set them."""
VARIANTS: dict[str, dict[str, int]] = {
    "plain diffuse and specular": {"SHADING": Shading.LAMBERT.number},
    "subsurface scattering, scalar": {"TIER": Tier.SCALAR.number},
    "subsurface scattering, tensor": {"TIER": Tier.TENSOR.number},
    "subsurface scattering, diffused normals": {},
    "the same, 2 normal fetches for 3": {"FETCHES": 2},
    "and deep scatter, 8 taps": {"TAPS": 8},
    "and deep scatter, 32 taps": {"TAPS": 32},
    "the formulas of 2014, 8 taps": {"SHADING": Shading.CLASSIC.number, "TAPS": 8},
}
"""Constants by label; the first variant is the baseline of the ratios."""
STAGES = {"vertex_main": "vertex", "fragment_main": "fragment"}


class AbsentDriverError(Exception):
    """No driver on this machine can compile for a GPU that is not installed."""


class AbsentDevice:
    """A device of Mesa's driver for a GPU that is not installed: it compiles, but cannot run anything.

    Parameters
    ----------
    family
        Mesa's name of the GPU.
    """

    def __init__(self, family: str) -> None:
        os.environ |= {"RADV_FORCE_FAMILY": family, "RADV_DEBUG": "nocache"}
        try:
            import vulkan as vk
        except (ImportError, OSError) as error:
            raise AbsentDriverError(f"Vulkan cannot be loaded ({error})") from None
        self._vk = vk
        application = vk.VkApplicationInfo(apiVersion=vk.VK_MAKE_VERSION(1, 2, 0))
        try:
            self._instance = vk.vkCreateInstance(
                vk.VkInstanceCreateInfo(pApplicationInfo=application), None
            )
        except vk.VkErrorIncompatibleDriver:
            raise AbsentDriverError("no Vulkan driver is installed") from None
        for physical_device in vk.vkEnumeratePhysicalDevices(self._instance):
            properties = vk.vkGetPhysicalDeviceProperties(physical_device)
            if "Null hardware" in properties.deviceName:
                break
        else:
            raise AbsentDriverError("Mesa's driver for AMD's GPUs is not installed")
        queue = vk.VkDeviceQueueCreateInfo(queueFamilyIndex=0, queueCount=1, pQueuePriorities=[1.0])
        features = vk.VkPhysicalDevicePipelineExecutablePropertiesFeaturesKHR(
            pipelineExecutableInfo=True
        )
        self._device = vk.vkCreateDevice(
            physical_device,
            vk.VkDeviceCreateInfo(
                pNext=features,
                pQueueCreateInfos=[queue],
                ppEnabledExtensionNames=["VK_KHR_pipeline_executable_properties"],
            ),
            None,
        )
        self._shared = self._skin_pass()

    def _skin_pass(self) -> dict[str, Any]:
        """Return the state that all pipelines of the skin pass share."""
        vk, device = self._vk, self._device
        code = assemble('#include "skin_pass.slang"', STAGES)
        self._module = vk.vkCreateShaderModule(
            device, vk.VkShaderModuleCreateInfo(codeSize=len(code), pCode=code), None
        )
        bindings = [
            vk.VkDescriptorSetLayoutBinding(
                binding=point.binding,
                descriptorType=self._descriptor_type(point.space, point.kind),
                descriptorCount=1,
                stageFlags=vk.VK_SHADER_STAGE_ALL,
            )
            for point in bind_points(generated_text("skin_pass.wgsl")).values()
        ]
        group = vk.vkCreateDescriptorSetLayout(
            device, vk.VkDescriptorSetLayoutCreateInfo(pBindings=bindings), None
        )
        formats = (vk.VK_FORMAT_R32G32B32A32_SFLOAT, vk.VK_FORMAT_D32_SFLOAT)
        attachments = [vk.VkAttachmentDescription(format=format_, samples=1) for format_ in formats]
        colour, depth = (
            vk.VkAttachmentReference(attachment=index, layout=vk.VK_IMAGE_LAYOUT_GENERAL)
            for index in (0, 1)
        )
        subpass = vk.VkSubpassDescription(
            pipelineBindPoint=vk.VK_PIPELINE_BIND_POINT_GRAPHICS,
            pColorAttachments=[colour],
            pDepthStencilAttachment=[depth],
        )
        attributes = [
            vk.VkVertexInputAttributeDescription(
                location=index,
                binding=0,
                format=vk.VK_FORMAT_R32G32B32A32_SFLOAT,
                offset=16 * index,
            )
            for index in range(VERTEX_VECTORS)
        ]
        vertex = vk.VkVertexInputBindingDescription(
            binding=0, stride=16 * VERTEX_VECTORS, inputRate=0
        )
        blend = vk.VkPipelineColorBlendAttachmentState(colorWriteMask=15)
        return {
            "layout": vk.vkCreatePipelineLayout(
                device, vk.VkPipelineLayoutCreateInfo(pSetLayouts=[group]), None
            ),
            "renderPass": vk.vkCreateRenderPass(
                device,
                vk.VkRenderPassCreateInfo(pAttachments=attachments, pSubpasses=[subpass]),
                None,
            ),
            "pVertexInputState": vk.VkPipelineVertexInputStateCreateInfo(
                pVertexBindingDescriptions=[vertex], pVertexAttributeDescriptions=attributes
            ),
            "pInputAssemblyState": vk.VkPipelineInputAssemblyStateCreateInfo(
                topology=vk.VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST
            ),
            "pViewportState": vk.VkPipelineViewportStateCreateInfo(viewportCount=1, scissorCount=1),
            "pRasterizationState": vk.VkPipelineRasterizationStateCreateInfo(lineWidth=1.0),
            "pMultisampleState": vk.VkPipelineMultisampleStateCreateInfo(rasterizationSamples=1),
            "pDepthStencilState": vk.VkPipelineDepthStencilStateCreateInfo(
                depthTestEnable=True, depthCompareOp=vk.VK_COMPARE_OP_LESS_OR_EQUAL
            ),
            "pColorBlendState": vk.VkPipelineColorBlendStateCreateInfo(pAttachments=[blend]),
            "pDynamicState": vk.VkPipelineDynamicStateCreateInfo(
                pDynamicStates=[vk.VK_DYNAMIC_STATE_VIEWPORT, vk.VK_DYNAMIC_STATE_SCISSOR]
            ),
        }

    def _descriptor_type(self, space: str, kind: str) -> int:
        vk = self._vk
        if space == "uniform":
            return vk.VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER
        if space:
            return vk.VK_DESCRIPTOR_TYPE_STORAGE_BUFFER
        sampler = kind == "sampler"
        return vk.VK_DESCRIPTOR_TYPE_SAMPLER if sampler else vk.VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE

    def statistics(self, constants: dict[int, int]) -> dict[str, int]:
        """Return the driver's statistics of the fragment stage, by name.

        Parameters
        ----------
        constants
            Values of specialization constants, by number.
        """
        vk = self._vk
        data = vk.ffi.new("int32_t[]", list(constants.values()))
        entries = [
            vk.VkSpecializationMapEntry(constantID=number, offset=4 * index, size=4)
            for index, number in enumerate(constants)
        ]
        specialization = vk.VkSpecializationInfo(
            pMapEntries=entries, dataSize=4 * len(entries), pData=data
        )
        stages = [
            vk.VkPipelineShaderStageCreateInfo(
                stage=getattr(vk, f"VK_SHADER_STAGE_{stage.upper()}_BIT"),
                module=self._module,
                pName=entry,
                pSpecializationInfo=specialization,
            )
            for entry, stage in STAGES.items()
        ]
        description = vk.VkGraphicsPipelineCreateInfo(
            flags=vk.VK_PIPELINE_CREATE_CAPTURE_STATISTICS_BIT_KHR, pStages=stages, **self._shared
        )
        pipeline = vk.vkCreateGraphicsPipelines(self._device, None, 1, [description], None)[0]
        executables_of, statistics_of = (
            vk.vkGetDeviceProcAddr(self._device, f"vkGetPipelineExecutable{name}KHR")
            for name in ("Properties", "Statistics")
        )
        executables = executables_of(self._device, vk.VkPipelineInfoKHR(pipeline=pipeline))
        names = [executable.name for executable in executables]
        fragment = vk.VkPipelineExecutableInfoKHR(
            pipeline=pipeline, executableIndex=names.index("Fragment Shader")
        )
        statistics = statistics_of(self._device, fragment)
        return {statistic.name: int(statistic.value.u64) for statistic in statistics}


def variant_constants() -> list[dict[int, int]]:
    """Return the constants of every variant with every filter, by number."""
    ids = override_ids(generated_text("skin_pass.wgsl"))
    named = [
        {**BASE, **changes, "SHADOW_FILTER": kind.number}
        for kind, changes in product(ShadowFilter, VARIANTS.values())
    ]
    return [{int(ids[name]): value for name, value in values.items()} for values in named]


def count_in_process(family: str) -> list[tuple[int, int]] | None:
    """Return cycles and registers of all variants, counted in a new process; None if it fails."""
    done = subprocess.run([sys.executable, __file__, family], capture_output=True, text=True)
    if done.returncode == 0:
        return json.loads(done.stdout)
    lines = done.stderr.strip().splitlines() or [f"the process ended with {done.returncode}"]
    print(f"{family}: {lines[-1]}", file=sys.stderr)
    return None


def print_counts(family: str) -> None:
    """Print cycles and registers of all variants on one GPU as JSON."""
    device = AbsentDevice(family)
    counts = [device.statistics(constants) for constants in variant_constants()]
    print(json.dumps([(count["Inverse Throughput"], count["VGPRs"]) for count in counts]))


def main() -> None:
    """Print the table, or the counts of the GPU that an argument names."""
    if len(sys.argv) > 1:
        print_counts(sys.argv[1])
        return
    columns = {}
    for label, families in FAMILIES.items():
        counts = next(filter(None, map(count_in_process, families)), None)
        if counts is not None:
            columns[label] = counts
    if not columns:
        print("Cycles are not counted: no driver can compile for a GPU that is not installed")
        return
    print("\nCycles of a wave's arithmetic, by Mesa's driver for GPUs that are not installed\n")
    print(f"| wide filter | shading | {' | '.join(columns)} | registers |")
    print("|---|---|" + "---|" * (len(columns) + 1))
    for row, (kind, name) in enumerate(product(ShadowFilter, VARIANTS)):
        baseline = row - row % len(VARIANTS)
        cells = [
            f"{counts[row][0]} ({counts[row][0] / counts[baseline][0]:.2f}×)"
            for counts in columns.values()
        ]
        registers = next(iter(columns.values()))[row][1]
        print(f"| {kind} | {name} | {' | '.join(cells)} | {registers} |")


if __name__ == "__main__":
    main()
