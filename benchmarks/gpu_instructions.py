"""What the skin pass costs on AMD's GPUs by their driver's own estimate: no hardware is needed.

Run by ``make bench``, or as ``python benchmarks/gpu_instructions.py``; prints Markdown. Mesa's driver
compiles for a GPU that is not there, and counts the cycles for which a wave keeps a compute unit busy, as if
every branch were taken and every fetch came at once: arithmetic, the same on every machine; neither bandwidth
nor what neighbouring pixels skip. It is given the source with its hints to unroll, which WGSL has not: a
driver that keeps a loop there does the same work in more instructions.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from itertools import product
from typing import Any

from skinshade.codegen.compiler import assemble
from skinshade.gpu.bindings import bind_points, override_ids
from skinshade.render.gpu.resources import ATTRIBUTES
from skinshade.shaders import generated_text

FAMILIES = {"RDNA 3": ("GFX1100", "NAVI31"), "RDNA 1": ("NAVI10",), "GCN 5": ("VEGA10",)}
"""As Mesa calls one GPU of each, of old and since; a name that it does not know ends the process."""
BASE = {
    "SHADING": 2,
    "TIER": 2,
    "VIEW": 0,
    "TAPS": 0,
    "LIGHTS": 1,
    "ENVIRONMENT": 1,
    "FETCHES": 3,
    "MULTISAMPLED": 0,
    "MAPS": 15,
    "LAMPS": 0,
}
WAYS: dict[str, dict[str, int]] = {
    "plain diffuse and specular": {"SHADING": 0},
    "subsurface scattering, scalar": {"TIER": 0},
    "subsurface scattering, tensor": {"TIER": 1},
    "subsurface scattering, diffused normals": {},
    "the same, 2 normal fetches for 3": {"FETCHES": 2},
    "and deep scatter, 8 taps": {"TAPS": 8},
    "and deep scatter, 32 taps": {"TAPS": 32},
    "the formulas of 2014, 8 taps": {"SHADING": 1, "TAPS": 8},
}
FILTERS = {"percentage-closer": 0, "variance": 1}
STAGES = {"vertex_main": "vertex", "fragment_main": "fragment"}


class AbsentDriverError(Exception):
    """There is no driver that would compile."""


class AbsentDevice:
    """A device of Mesa's driver for a GPU that is not there: it compiles, and runs nothing.

    Parameters
    ----------
    family
        Of the GPU, as Mesa calls it.
    """

    def __init__(self, family: str) -> None:
        os.environ |= {"RADV_FORCE_FAMILY": family, "RADV_DEBUG": "nocache"}
        try:
            import vulkan as vk
        except (ImportError, OSError) as error:
            raise AbsentDriverError(f"no Vulkan ({error})") from None
        self._vk = vk
        version = vk.VkApplicationInfo(apiVersion=vk.VK_MAKE_VERSION(1, 2, 0))
        described = vk.VkInstanceCreateInfo(pApplicationInfo=version)
        try:
            self._instance = vk.vkCreateInstance(described, None)
        except vk.VkErrorIncompatibleDriver:
            raise AbsentDriverError("no Vulkan driver is there") from None
        for each in vk.vkEnumeratePhysicalDevices(self._instance):
            properties = vk.vkGetPhysicalDeviceProperties(each)
            if "Null hardware" in properties.deviceName:
                break
        else:
            raise AbsentDriverError("Mesa's driver for AMD's GPUs is not there")
        queue = vk.VkDeviceQueueCreateInfo(queueFamilyIndex=0, queueCount=1, pQueuePriorities=[1.0])
        told = vk.VkPhysicalDevicePipelineExecutablePropertiesFeaturesKHR(
            pipelineExecutableInfo=True
        )
        self._device = vk.vkCreateDevice(
            each,
            vk.VkDeviceCreateInfo(
                pNext=told,
                pQueueCreateInfos=[queue],
                ppEnabledExtensionNames=["VK_KHR_pipeline_executable_properties"],
            ),
            None,
        )
        self._fixed = self._skin_pass()

    def _skin_pass(self) -> dict[str, Any]:
        """What all pipelines of the skin pass share."""
        vk, device = self._vk, self._device
        code = assemble('#include "../passes/skin_pass.slang"', STAGES)
        self._module = vk.vkCreateShaderModule(
            device, vk.VkShaderModuleCreateInfo(codeSize=len(code), pCode=code), None
        )
        bindings = [
            vk.VkDescriptorSetLayoutBinding(
                binding=point.binding,
                descriptorType=self._descriptor(point.space, point.kind),
                descriptorCount=1,
                stageFlags=vk.VK_SHADER_STAGE_ALL,
            )
            for point in bind_points(generated_text("skin_pass.wgsl")).values()
        ]
        group = vk.vkCreateDescriptorSetLayout(
            device, vk.VkDescriptorSetLayoutCreateInfo(pBindings=bindings), None
        )
        formats = (vk.VK_FORMAT_R32G32B32A32_SFLOAT, vk.VK_FORMAT_D32_SFLOAT)
        attachments = [vk.VkAttachmentDescription(format=each, samples=1) for each in formats]
        colour, depth = (
            vk.VkAttachmentReference(attachment=at, layout=vk.VK_IMAGE_LAYOUT_GENERAL)
            for at in (0, 1)
        )
        subpass = vk.VkSubpassDescription(
            pipelineBindPoint=vk.VK_PIPELINE_BIND_POINT_GRAPHICS,
            pColorAttachments=[colour],
            pDepthStencilAttachment=[depth],
        )
        attributes = [
            vk.VkVertexInputAttributeDescription(
                location=at, binding=0, format=vk.VK_FORMAT_R32G32B32A32_SFLOAT, offset=16 * at
            )
            for at in range(ATTRIBUTES)
        ]
        vertex = vk.VkVertexInputBindingDescription(binding=0, stride=16 * ATTRIBUTES, inputRate=0)
        written = vk.VkPipelineColorBlendAttachmentState(colorWriteMask=15)
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
            "pColorBlendState": vk.VkPipelineColorBlendStateCreateInfo(pAttachments=[written]),
            "pDynamicState": vk.VkPipelineDynamicStateCreateInfo(
                pDynamicStates=[vk.VK_DYNAMIC_STATE_VIEWPORT, vk.VK_DYNAMIC_STATE_SCISSOR]
            ),
        }

    def _descriptor(self, space: str, kind: str) -> int:
        vk = self._vk
        if space:
            uniform = space == "uniform"
            return (
                vk.VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER
                if uniform
                else vk.VK_DESCRIPTOR_TYPE_STORAGE_BUFFER
            )
        sampler = kind == "sampler"
        return vk.VK_DESCRIPTOR_TYPE_SAMPLER if sampler else vk.VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE

    def statistics(self, constants: dict[int, int]) -> dict[str, int]:
        """Return the driver's statistics of the fragment stage, by their names."""
        vk = self._vk
        data = vk.ffi.new("int32_t[]", list(constants.values()))
        entries = [
            vk.VkSpecializationMapEntry(constantID=name, offset=4 * at, size=4)
            for at, name in enumerate(constants)
        ]
        chosen = vk.VkSpecializationInfo(pMapEntries=entries, dataSize=4 * len(entries), pData=data)
        stages = [
            vk.VkPipelineShaderStageCreateInfo(
                stage=getattr(vk, f"VK_SHADER_STAGE_{stage.upper()}_BIT"),
                module=self._module,
                pName=entry,
                pSpecializationInfo=chosen,
            )
            for entry, stage in STAGES.items()
        ]
        described = vk.VkGraphicsPipelineCreateInfo(
            flags=vk.VK_PIPELINE_CREATE_CAPTURE_STATISTICS_BIT_KHR, pStages=stages, **self._fixed
        )
        pipeline = vk.vkCreateGraphicsPipelines(self._device, None, 1, [described], None)[0]
        ask = {
            name: vk.vkGetDeviceProcAddr(self._device, f"vkGetPipelineExecutable{name}KHR")
            for name in ("Properties", "Statistics")
        }
        executables = ask["Properties"](self._device, vk.VkPipelineInfoKHR(pipeline=pipeline))
        at = next(at for at, each in enumerate(executables) if each.name == "Fragment Shader")
        found = ask["Statistics"](
            self._device, vk.VkPipelineExecutableInfoKHR(pipeline=pipeline, executableIndex=at)
        )
        return {each.name: int(each.value.u64) for each in found}


def variants() -> list[dict[int, int]]:
    """Return the constants of every way with every filter, by their numbers."""
    ids = override_ids(generated_text("skin_pass.wgsl"))
    return [
        {int(ids[name]): value for name, value in {**BASE, **way, "SHADOW_FILTER": number}.items()}
        for number in FILTERS.values()
        for way in WAYS.values()
    ]


def counted(family: str) -> list[tuple[int, int]] | None:
    """Return cycles and registers of `variants` from a process of its own; None, said why, if it fails."""
    command = [sys.executable, __file__, family]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode == 0:
        return json.loads(done.stdout)
    why = done.stderr.strip().splitlines() or [f"ended with {done.returncode}"]
    print(f"{family}: {why[-1]}", file=sys.stderr)
    return None


def main() -> None:
    """Print the table, or what one GPU gives."""
    if len(sys.argv) > 1:
        device = AbsentDevice(sys.argv[1])
        told = [device.statistics(each) for each in variants()]
        print(json.dumps([(each["Inverse Throughput"], each["VGPRs"]) for each in told]))
        return
    columns = {
        called: next(filter(None, map(counted, families)), None)
        for called, families in FAMILIES.items()
    }
    there = {called: column for called, column in columns.items() if column is not None}
    if not there:
        print("No table of instructions")
        return
    print(
        "\nCycles of a wave's arithmetic, by the driver that Mesa has for GPUs that are not here\n"
    )
    print(f"| wide filter | shading | {' | '.join(there)} | registers |")
    print("|---|---|" + "---|" * (len(there) + 1))
    for row, (label, name) in enumerate(product(FILTERS, WAYS)):
        plain = row - row % len(WAYS)
        cells = [
            f"{column[row][0]} ({column[row][0] / column[plain][0]:.2f}×)"
            for column in there.values()
        ]
        registers = next(iter(there.values()))[row][1]
        print(f"| {label} | {name} | {' | '.join(cells)} | {registers} |")


if __name__ == "__main__":
    main()
