// window.rows: dispatches a kernel over `count` rows, which are whole work groups.
const adapter = await navigator.gpu?.requestAdapter();
if (!adapter) throw new Error("there is no adapter");
const device = await adapter.requestDevice({requiredFeatures: ["float32-filterable"]});
let module;
window.rows = async ({text, entry, places, group, count, width, data, textures}) => {
    device.pushErrorScope("validation");
    if (text) module = device.createShaderModule({code: text});
    const compute = {module, entryPoint: entry}, usage = GPUBufferUsage, entries = [];
    const pipeline = device.createComputePipeline({layout: "auto", compute});
    const given = floats(data), size = 4 * count * width;
    const buffer = (size, usage) => device.createBuffer({size, usage});
    const inputs = buffer(given.byteLength, usage.STORAGE | usage.COPY_DST);
    const outputs = buffer(size, usage.STORAGE | usage.COPY_SRC);
    const read = buffer(size, usage.MAP_READ | usage.COPY_DST);
    device.queue.writeBuffer(inputs, 0, given);
    const bind = (name, resource) => entries.push({binding: places[name], resource});
    bind("inputs", {buffer: inputs});
    bind("outputs", {buffer: outputs});
    const made = textures.map(each => {
        const size = [each.width, each.height];
        const texture = device.createTexture({
            size, format: "rgba32float",
            usage: GPUTextureUsage.TEXTURE_BINDING | GPUTextureUsage.COPY_DST,
        });
        const layout = {bytesPerRow: 16 * each.width};
        device.queue.writeTexture({texture}, floats(each.data), layout, size);
        bind(each.name, texture.createView());
        bind(each.name + "_sampler", device.createSampler(each.sampled));
        return texture;
    });
    const bound = device.createBindGroup({layout: pipeline.getBindGroupLayout(0), entries});
    const encoder = device.createCommandEncoder(), work = encoder.beginComputePass();
    work.setPipeline(pipeline);
    work.setBindGroup(0, bound);
    work.dispatchWorkgroups(count / group);
    work.end();
    encoder.copyBufferToBuffer(outputs, 0, read, 0, size);
    device.queue.submit([encoder.finish()]);
    const error = await device.popErrorScope();
    if (error) throw new Error(error.message);
    await read.mapAsync(GPUMapMode.READ);
    const found = asText(new Float32Array(read.getMappedRange()));
    [inputs, outputs, read, ...made].forEach(each => each.destroy());
    return found;
};
