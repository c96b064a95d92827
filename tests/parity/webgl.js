// window.rows: draws `count` rows into a float texture, four floats of a result to a fragment.
const gl = document.createElement("canvas").getContext("webgl2");
if (!gl) throw new Error("there is no WebGL 2");
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
const texture = (unit, inner, format, width, height, data, {linear = false, around = false} = {}) => {
    const made = gl.createTexture(), filter = linear ? gl.LINEAR : gl.NEAREST;
    gl.activeTexture(gl.TEXTURE0 + unit);
    gl.bindTexture(gl.TEXTURE_2D, made);
    gl.texImage2D(gl.TEXTURE_2D, 0, inner, width, height, 0, format, gl.FLOAT, data);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, filter);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, filter);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, around ? gl.REPEAT : gl.CLAMP_TO_EDGE);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
    return made;
};
window.rows = ({vertex, fragment, count, length, width, data, textures}) => {
    const program = linked([[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]);
    const fours = Math.ceil(width / 4);
    gl.useProgram(program);
    const made = [texture(0, gl.R32F, gl.RED, length, count, floats(data))];
    gl.uniform1i(gl.getUniformLocation(program, "inputs"), 0);
    textures.forEach((each, i) => {
        const texels = floats(each.data);
        made.push(texture(i + 1, gl.RGBA32F, gl.RGBA, each.width, each.height, texels, each));
        gl.uniform1i(gl.getUniformLocation(program, each.name), i + 1);
    });
    const target = texture(15, gl.RGBA32F, gl.RGBA, fours, count, null);
    const frame = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, target, 0);
    if (gl.checkFramebufferStatus(gl.FRAMEBUFFER) !== gl.FRAMEBUFFER_COMPLETE)
        throw new Error("the framebuffer is not complete");
    gl.viewport(0, 0, fours, count);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    const found = new Float32Array(4 * fours * count);
    gl.readPixels(0, 0, fours, count, gl.RGBA, gl.FLOAT, found);
    const error = gl.getError();
    gl.deleteFramebuffer(frame);
    [target, ...made].forEach(each => gl.deleteTexture(each));
    gl.deleteProgram(program);
    if (error) throw new Error("WebGL error " + error);
    return asText(found);
};
