// window.rows draws `count` rows into a float texture; each fragment writes four floats of a result.
const gl = document.createElement("canvas").getContext("webgl2");
if (!gl) throw new Error("WebGL 2 is not available");
for (const name of ["EXT_color_buffer_float", "OES_texture_float_linear"])
    if (!gl.getExtension(name)) throw new Error(name + " is missing");
const linked = sources => {
    const program = gl.createProgram();
    for (const [kind, text] of sources) {
        const shader = gl.createShader(kind);
        gl.shaderSource(shader, text);
        gl.compileShader(shader);
        if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS))
            throw new Error(gl.getShaderInfoLog(shader));
        gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS))
        throw new Error(gl.getProgramInfoLog(program));
    return program;
};
const newTexture = (unit, inner, format, width, height, data, {linear = false, repeatsU = false} = {}) => {
    const texture = gl.createTexture(), filter = linear ? gl.LINEAR : gl.NEAREST;
    gl.activeTexture(gl.TEXTURE0 + unit);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texImage2D(gl.TEXTURE_2D, 0, inner, width, height, 0, format, gl.FLOAT, data);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, filter);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, filter);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, repeatsU ? gl.REPEAT : gl.CLAMP_TO_EDGE);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
    return texture;
};
window.rows = ({vertex, fragment, count, length, width, data, textures}) => {
    const program = linked([[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]);
    const texels = Math.ceil(width / 4);
    gl.useProgram(program);
    const created = [newTexture(0, gl.R32F, gl.RED, length, count, floats(data))];
    gl.uniform1i(gl.getUniformLocation(program, "inputs"), 0);
    textures.forEach((image, i) => {
        const {name, width, height} = image;
        created.push(newTexture(i + 1, gl.RGBA32F, gl.RGBA, width, height, floats(image.data), image));
        gl.uniform1i(gl.getUniformLocation(program, name), i + 1);
    });
    const target = newTexture(15, gl.RGBA32F, gl.RGBA, texels, count, null);
    const frame = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, target, 0);
    if (gl.checkFramebufferStatus(gl.FRAMEBUFFER) !== gl.FRAMEBUFFER_COMPLETE)
        throw new Error("the framebuffer is not complete");
    gl.viewport(0, 0, texels, count);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    const result = new Float32Array(4 * texels * count);
    gl.readPixels(0, 0, texels, count, gl.RGBA, gl.FLOAT, result);
    const error = gl.getError();
    gl.deleteFramebuffer(frame);
    [target, ...created].forEach(texture => gl.deleteTexture(texture));
    gl.deleteProgram(program);
    if (error) throw new Error("WebGL error " + error);
    return asText(result);
};
