// window.rows dispatches a kernel over `count` rows, which are whole work groups.
const adapter = await navigator.gpu?.requestAdapter();
if (!adapter) throw new Error("WebGPU has no adapter");
const device = await adapter.requestDevice({requiredFeatures: ["float32-filterable"]});
let module;
window.rows = async ({text, entry, bindings, group, count, width, data, textures}) => {
    device.pushErrorScope("validation");
    if (text) module = device.createShaderModule({code: text});
    const compute = {module, entryPoint: entry}, usage = GPUBufferUsage, entries = [];
    const pipeline = device.createComputePipeline({layout: "auto", compute});
    const numbers = floats(data), size = 4 * count * width;
    const buffer = (size, usage) => device.createBuffer({size, usage});
    const inputs = buffer(numbers.byteLength, usage.STORAGE | usage.COPY_DST);
    const outputs = buffer(size, usage.STORAGE | usage.COPY_SRC);
    const read = buffer(size, usage.MAP_READ | usage.COPY_DST);
    device.queue.writeBuffer(inputs, 0, numbers);
    const bind = (name, resource) => entries.push({binding: bindings[name], resource});
    bind("inputs", {buffer: inputs});
    bind("outputs", {buffer: outputs});
    const created = textures.map(image => {
        const size = [image.width, image.height];
        const texture = device.createTexture({
            size, format: "rgba32float",
            usage: GPUTextureUsage.TEXTURE_BINDING | GPUTextureUsage.COPY_DST,
        });
        const layout = {bytesPerRow: 16 * image.width};
        device.queue.writeTexture({texture}, floats(image.data), layout, size);
        bind(image.name, texture.createView());
        bind(image.name + "_sampler", device.createSampler(image.sampler));
        return texture;
    });
    const bindGroup = device.createBindGroup({layout: pipeline.getBindGroupLayout(0), entries});
    const encoder = device.createCommandEncoder(), work = encoder.beginComputePass();
    work.setPipeline(pipeline);
    work.setBindGroup(0, bindGroup);
    work.dispatchWorkgroups(count / group);
    work.end();
    encoder.copyBufferToBuffer(outputs, 0, read, 0, size);
    device.queue.submit([encoder.finish()]);
    const error = await device.popErrorScope();
    if (error) throw new Error(error.message);
    await read.mapAsync(GPUMapMode.READ);
    const result = asText(new Float32Array(read.getMappedRange()));
    [inputs, outputs, read, ...created].forEach(resource => resource.destroy());
    return result;
};
