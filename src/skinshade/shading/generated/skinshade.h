/* skinshade.h: the constant blocks of the skinshade shader library, for C99 and C++.
   Generated from skinshade.params by `python -m codegen`. It needs no other file.

   Take a configuration with its defaults, change it, and pack it into the bytes that the shader reads
   (the same bytes for std140, an HLSL cbuffer and a WGSL uniform):

       skinshade_skin_config config = skinshade_skin_defaults();
       config.gloss = 0.4f;
       unsigned char bytes[SKINSHADE_SKIN_BLOCK_SIZE];
       skinshade_result result = skinshade_pack_skin(&config, bytes, sizeof bytes);
       if (result.error != SKINSHADE_OK) { ... skinshade_error_message(result.error), result.field ... }

   Lengths are in millimetres and curvatures in 1/mm, whatever the unit of your scene is. */
#ifndef SKINSHADE_H
#define SKINSHADE_H

#define SKINSHADE_VERSION "0.1.0"

#include <math.h>
#include <stddef.h>
#include <string.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(__GNUC__) || defined(__clang__)
#define SKINSHADE_FUNCTION static inline __attribute__((unused))
#else
#define SKINSHADE_FUNCTION static inline
#endif

typedef enum skinshade_error {
    SKINSHADE_OK = 0,
    SKINSHADE_NULL_POINTER = 1,
    SKINSHADE_BUFFER_TOO_SMALL = 2,
    SKINSHADE_NOT_FINITE = 3,
    SKINSHADE_OUT_OF_RANGE = 4
} skinshade_error;

/* Result of packing: the first error, and the name of the field at fault or NULL. */
typedef struct skinshade_result {
    skinshade_error error;
    const char *field;
} skinshade_result;

SKINSHADE_FUNCTION const char *skinshade_error_message(skinshade_error error)
{
    switch (error) {
    case SKINSHADE_OK: return "no error";
    case SKINSHADE_NULL_POINTER: return "the configuration or the buffer is a null pointer";
    case SKINSHADE_BUFFER_TOO_SMALL: return "the buffer is smaller than the block";
    case SKINSHADE_NOT_FINITE: return "a field is infinite or not a number";
    case SKINSHADE_OUT_OF_RANGE: return "a field lies outside the range that its comment gives";
    }
    return "unknown error";
}

SKINSHADE_FUNCTION skinshade_result skinshade_result_of(skinshade_error error, const char *field)
{
    skinshade_result result;
    result.error = error;
    result.field = field;
    return result;
}

SKINSHADE_FUNCTION skinshade_error skinshade_check(
    const float *values, size_t count, double low, double high)
{
    for (size_t i = 0; i < count; i++) {
        if (!isfinite(values[i])) return SKINSHADE_NOT_FINITE;
        if (values[i] < (float)low || values[i] > (float)high) return SKINSHADE_OUT_OF_RANGE;
    }
    return SKINSHADE_OK;
}

#define SKINSHADE_SKIN_BLOCK_SIZE 80

typedef struct skinshade_skin_config {
    float scatter_scale; /* 0.05..20. Factor on every length of the diffusion profile. */
    float normal_strength; /* 0..2. Factor on the slopes of the normal map. */
    float gloss; /* 0..1. Gloss of the first specular lobe, whose Blinn-Phong power is 2^(13 gloss). */
    float reflectance; /* 0..0.2. Specular reflectance at normal incidence; .028 for skin, whose refractive index is 1.4. */
    float shadow_filter_width_mm; /* 1..100 mm. Width of the wide shadow filter, across the light. */
    float shadow_sharpening; /* 1..100. Width of the wide shadow filter, divided by the width of the edge of a cast shadow. */
    float deep_scatter_strength; /* 0..10. Factor on light that passes through the body; 1 is physically correct. */
    float deep_scatter_offset_mm; /* 0..10 mm. Distance by which a point moves inwards before its depth is compared. */
    float deep_scatter_filter_mm; /* 0..20 mm. Radius of the disk over which thickness is averaged. */
    float deep_scatter_sigma_per_mm[3]; /* 0..50 1/mm. Decay of light that passes through the body; 0 means 1.2/rms radius. */
    float deep_scatter_tint[3]; /* 0..1. Colour of light that passes through the body, multiplied by the colour of its map. */
    float classic_deep_scatter_radius_mm; /* 0.1..100 mm. Radius of the falloff of deep scatter in classic shading. */
} skinshade_skin_config;

SKINSHADE_FUNCTION skinshade_skin_config skinshade_skin_defaults(void)
{
    skinshade_skin_config config;
    config.scatter_scale = 1.0f;
    config.normal_strength = 1.0f;
    config.gloss = 0.35f;
    config.reflectance = 0.028f;
    config.shadow_filter_width_mm = 8.0f;
    config.shadow_sharpening = 8.0f;
    config.deep_scatter_strength = 1.0f;
    config.deep_scatter_offset_mm = 0.6f;
    config.deep_scatter_filter_mm = 2.5f;
    config.deep_scatter_sigma_per_mm[0] = 0.0f;
    config.deep_scatter_sigma_per_mm[1] = 0.0f;
    config.deep_scatter_sigma_per_mm[2] = 0.0f;
    config.deep_scatter_tint[0] = 1.0f;
    config.deep_scatter_tint[1] = 1.0f;
    config.deep_scatter_tint[2] = 1.0f;
    config.classic_deep_scatter_radius_mm = 5.5f;
    return config;
}

SKINSHADE_FUNCTION skinshade_result skinshade_pack_skin(
    const skinshade_skin_config *config, void *bytes, size_t size)
{
    unsigned char *block = (unsigned char *)bytes;
    skinshade_error error;
    if (config == NULL || bytes == NULL)
        return skinshade_result_of(SKINSHADE_NULL_POINTER, NULL);
    if (size < SKINSHADE_SKIN_BLOCK_SIZE)
        return skinshade_result_of(SKINSHADE_BUFFER_TOO_SMALL, NULL);
    error = skinshade_check(&config->scatter_scale, 1, 0.05, 20.0);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "scatter_scale");
    error = skinshade_check(&config->normal_strength, 1, 0.0, 2.0);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "normal_strength");
    error = skinshade_check(&config->gloss, 1, 0.0, 1.0);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "gloss");
    error = skinshade_check(&config->reflectance, 1, 0.0, 0.2);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "reflectance");
    error = skinshade_check(&config->shadow_filter_width_mm, 1, 1.0, 100.0);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "shadow_filter_width_mm");
    error = skinshade_check(&config->shadow_sharpening, 1, 1.0, 100.0);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "shadow_sharpening");
    error = skinshade_check(&config->deep_scatter_strength, 1, 0.0, 10.0);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "deep_scatter_strength");
    error = skinshade_check(&config->deep_scatter_offset_mm, 1, 0.0, 10.0);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "deep_scatter_offset_mm");
    error = skinshade_check(&config->deep_scatter_filter_mm, 1, 0.0, 20.0);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "deep_scatter_filter_mm");
    error = skinshade_check(config->deep_scatter_sigma_per_mm, 3, 0.0, 50.0);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "deep_scatter_sigma_per_mm");
    error = skinshade_check(config->deep_scatter_tint, 3, 0.0, 1.0);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "deep_scatter_tint");
    error = skinshade_check(&config->classic_deep_scatter_radius_mm, 1, 0.1, 100.0);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "classic_deep_scatter_radius_mm");
    memset(block, 0, SKINSHADE_SKIN_BLOCK_SIZE);
    memcpy(block + 32, &config->scatter_scale, 4);
    memcpy(block + 36, &config->normal_strength, 4);
    memcpy(block + 40, &config->gloss, 4);
    memcpy(block + 44, &config->reflectance, 4);
    memcpy(block + 48, &config->shadow_filter_width_mm, 4);
    memcpy(block + 52, &config->shadow_sharpening, 4);
    memcpy(block + 56, &config->deep_scatter_strength, 4);
    memcpy(block + 60, &config->deep_scatter_offset_mm, 4);
    memcpy(block + 64, &config->deep_scatter_filter_mm, 4);
    memcpy(block + 0, config->deep_scatter_sigma_per_mm, 12);
    memcpy(block + 16, config->deep_scatter_tint, 12);
    memcpy(block + 68, &config->classic_deep_scatter_radius_mm, 4);
    return skinshade_result_of(SKINSHADE_OK, NULL);
}

#define SKINSHADE_SCATTER_BLOCK_SIZE 224

typedef struct skinshade_scatter_config {
    float albedo[3]; /* 0.0001..0.9999. Diffuse albedo of the profile. */
    float rms_radius_mm[3]; /* 0..10000 mm. Root mean square radius of the profile. */
    float sigma_per_mm[3]; /* 0..1e+06 1/mm. Decay of light that passes through the body. */
    float blend_red[3]; /* 0..1. Weights of the sharp, narrow and wide normal for red light. */
    float blend_green[3]; /* 0..1. Weights of the sharp, narrow and wide normal for green light. */
    float blend_blue[3]; /* 0..1. Weights of the sharp, narrow and wide normal for blue light. */
    float ring_axes[4]; /* -1e+06..1e+06. Axes of the ring's table, rows sqrt (1/mm): low and 1/(high - low) of the columns, then of the rows. */
    float sphere_axes[4]; /* -1e+06..1e+06. Axes of the sphere's table, rows sqrt (1/mm): low and 1/(high - low) of the columns, then of the rows. */
    float transfer_axes[4]; /* -1e+06..1e+06. Axes of T(k), columns sqrt (rad/mm): low and 1/(high - low) of the columns, then of the rows. */
    float shadow_axes[4]; /* -1e+06..1e+06. Axes of the shadow table, rows 1/mm: low and 1/(high - low) of the columns, then of the rows. */
    float classic_axes[4]; /* -1e+06..1e+06. Axes of the curvature table of 2014, rows 1/mm: low and 1/(high - low) of the columns, then of the rows. */
    float classic_shadow_axes[4]; /* -1e+06..1e+06. Axes of the shadow table of 2014, rows 1/mm: low and 1/(high - low) of the columns, then of the rows. */
    float coat_axes[4]; /* -1e+06..1e+06. Axes of the coat's table, columns sqrt (N·V), rows gloss: low and 1/(high - low) of the columns, then of the rows. */
    float normal_sigmas_mm[2]; /* 0..10000 mm. Standard deviations of the narrow and the wide blur of the normal map. */
    float coat_reflectance; /* 0..0.2. Reflectance at normal incidence that the coat's table was built for. */
} skinshade_scatter_config;

SKINSHADE_FUNCTION skinshade_scatter_config skinshade_scatter_defaults(void)
{
    skinshade_scatter_config config;
    config.albedo[0] = 0.436f;
    config.albedo[1] = 0.227f;
    config.albedo[2] = 0.131f;
    config.rms_radius_mm[0] = 2.42f;
    config.rms_radius_mm[1] = 1.06f;
    config.rms_radius_mm[2] = 0.66f;
    config.sigma_per_mm[0] = 0.5f;
    config.sigma_per_mm[1] = 1.1f;
    config.sigma_per_mm[2] = 1.8f;
    config.blend_red[0] = 1.0f;
    config.blend_red[1] = 0.0f;
    config.blend_red[2] = 0.0f;
    config.blend_green[0] = 1.0f;
    config.blend_green[1] = 0.0f;
    config.blend_green[2] = 0.0f;
    config.blend_blue[0] = 1.0f;
    config.blend_blue[1] = 0.0f;
    config.blend_blue[2] = 0.0f;
    config.ring_axes[0] = -1.0f;
    config.ring_axes[1] = 0.5f;
    config.ring_axes[2] = 0.0f;
    config.ring_axes[3] = 1.0f;
    config.sphere_axes[0] = -1.0f;
    config.sphere_axes[1] = 0.5f;
    config.sphere_axes[2] = 0.0f;
    config.sphere_axes[3] = 1.0f;
    config.transfer_axes[0] = 0.0f;
    config.transfer_axes[1] = 1.0f;
    config.transfer_axes[2] = 0.0f;
    config.transfer_axes[3] = 1.0f;
    config.shadow_axes[0] = 0.0f;
    config.shadow_axes[1] = 1.0f;
    config.shadow_axes[2] = 0.0f;
    config.shadow_axes[3] = 1.0f;
    config.classic_axes[0] = -1.0f;
    config.classic_axes[1] = 0.5f;
    config.classic_axes[2] = 0.0f;
    config.classic_axes[3] = 1.0f;
    config.classic_shadow_axes[0] = 0.0f;
    config.classic_shadow_axes[1] = 1.0f;
    config.classic_shadow_axes[2] = 0.0f;
    config.classic_shadow_axes[3] = 1.0f;
    config.coat_axes[0] = 0.0f;
    config.coat_axes[1] = 1.0f;
    config.coat_axes[2] = 0.0f;
    config.coat_axes[3] = 1.0f;
    config.normal_sigmas_mm[0] = 0.0f;
    config.normal_sigmas_mm[1] = 0.0f;
    config.coat_reflectance = 0.028f;
    return config;
}

SKINSHADE_FUNCTION skinshade_result skinshade_pack_scatter(
    const skinshade_scatter_config *config, void *bytes, size_t size)
{
    unsigned char *block = (unsigned char *)bytes;
    skinshade_error error;
    if (config == NULL || bytes == NULL)
        return skinshade_result_of(SKINSHADE_NULL_POINTER, NULL);
    if (size < SKINSHADE_SCATTER_BLOCK_SIZE)
        return skinshade_result_of(SKINSHADE_BUFFER_TOO_SMALL, NULL);
    error = skinshade_check(config->albedo, 3, 0.0001, 0.9999);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "albedo");
    error = skinshade_check(config->rms_radius_mm, 3, 0.0, 10000.0);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "rms_radius_mm");
    error = skinshade_check(config->sigma_per_mm, 3, 0.0, 1000000.0);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "sigma_per_mm");
    error = skinshade_check(config->blend_red, 3, 0.0, 1.0);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "blend_red");
    error = skinshade_check(config->blend_green, 3, 0.0, 1.0);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "blend_green");
    error = skinshade_check(config->blend_blue, 3, 0.0, 1.0);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "blend_blue");
    error = skinshade_check(config->ring_axes, 4, -1000000.0, 1000000.0);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "ring_axes");
    error = skinshade_check(config->sphere_axes, 4, -1000000.0, 1000000.0);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "sphere_axes");
    error = skinshade_check(config->transfer_axes, 4, -1000000.0, 1000000.0);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "transfer_axes");
    error = skinshade_check(config->shadow_axes, 4, -1000000.0, 1000000.0);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "shadow_axes");
    error = skinshade_check(config->classic_axes, 4, -1000000.0, 1000000.0);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "classic_axes");
    error = skinshade_check(config->classic_shadow_axes, 4, -1000000.0, 1000000.0);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "classic_shadow_axes");
    error = skinshade_check(config->coat_axes, 4, -1000000.0, 1000000.0);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "coat_axes");
    error = skinshade_check(config->normal_sigmas_mm, 2, 0.0, 10000.0);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "normal_sigmas_mm");
    error = skinshade_check(&config->coat_reflectance, 1, 0.0, 0.2);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "coat_reflectance");
    memset(block, 0, SKINSHADE_SCATTER_BLOCK_SIZE);
    memcpy(block + 0, config->albedo, 12);
    memcpy(block + 16, config->rms_radius_mm, 12);
    memcpy(block + 32, config->sigma_per_mm, 12);
    memcpy(block + 48, config->blend_red, 12);
    memcpy(block + 64, config->blend_green, 12);
    memcpy(block + 80, config->blend_blue, 12);
    memcpy(block + 96, config->ring_axes, 16);
    memcpy(block + 112, config->sphere_axes, 16);
    memcpy(block + 128, config->transfer_axes, 16);
    memcpy(block + 144, config->shadow_axes, 16);
    memcpy(block + 160, config->classic_axes, 16);
    memcpy(block + 176, config->classic_shadow_axes, 16);
    memcpy(block + 192, config->coat_axes, 16);
    memcpy(block + 208, config->normal_sigmas_mm, 8);
    memcpy(block + 216, &config->coat_reflectance, 4);
    return skinshade_result_of(SKINSHADE_OK, NULL);
}

#ifdef __cplusplus
}
#endif

#endif
