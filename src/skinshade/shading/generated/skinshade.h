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

#define SKINSHADE_EYE_BLOCK_SIZE 96

typedef struct skinshade_eye_config {
    float iris_uv[4]; /* -16..16. Centre of the iris in its map, its radius there, and turns counterclockwise. */
    float sclera_radius_mm; /* 8..16 mm. Radius of the sclera. */
    float limbus_radius_mm; /* 4..8 mm. Radius of the limbus, where cornea and sclera meet; half the white-to-white distance. */
    float limbus_width_mm; /* 0.1..1.5 mm. Half the width of the blend between cornea and sclera. */
    float cornea_radius_mm; /* 6..10 mm. Radius of curvature at the apex of the cornea. */
    float cornea_asphericity; /* -0.8..0.3. Asphericity Q of the cornea; 0 for a sphere. */
    float refraction_index; /* 1..1.6. Index of the one refracting surface that replaces both surfaces of the cornea. */
    float tear_index; /* 1..1.6. Index of tears, which reflect. */
    float aqueous_index; /* 1..1.6. Index of the aqueous humour. */
    float iris_depth_mm; /* 1..6 mm. Depth of the iris behind the apex of the cornea, on the axis. */
    float iris_slope; /* -0.3..0.3. Fall of the iris with the distance from the axis; 0 for a plane. */
    float iris_radius_mm; /* 3..8 mm. Outer radius of the iris. */
    float pupil_radius_mm; /* 0.5..4.5 mm. Radius of the pupil. */
    float pupil_in_map; /* 0..0.9. Radius of the pupil in the map of the iris, over that of the iris. */
    float virtual_cornea; /* 0..1. 1 for a mesh without a bulge: rays meet the cornea itself. */
    float cornea_roughness_deg; /* 0.1..10 deg. Angle by which the cornea widens a reflection. */
    float sclera_roughness_deg; /* 1..20 deg. Angle by which the sclera widens a reflection. */
    float sclera_normal_strength; /* 0..2. Factor on the slopes of the normal map of the sclera. */
    float meniscus_height_mm; /* 0..0.7 mm. Height of the tears on the margins of the lids. */
    float iris_height_mm; /* 0..0.3 mm. Height of the relief of the iris at 1 in its map. */
} skinshade_eye_config;

SKINSHADE_FUNCTION skinshade_eye_config skinshade_eye_defaults(void)
{
    skinshade_eye_config config;
    config.iris_uv[0] = 0.5f;
    config.iris_uv[1] = 0.5f;
    config.iris_uv[2] = 0.5f;
    config.iris_uv[3] = 0.0f;
    config.sclera_radius_mm = 12.0f;
    config.limbus_radius_mm = 5.9f;
    config.limbus_width_mm = 0.6f;
    config.cornea_radius_mm = 7.8f;
    config.cornea_asphericity = -0.26f;
    config.refraction_index = 1.34f;
    config.tear_index = 1.337f;
    config.aqueous_index = 1.336f;
    config.iris_depth_mm = 3.55f;
    config.iris_slope = 0.08f;
    config.iris_radius_mm = 6.0f;
    config.pupil_radius_mm = 2.0f;
    config.pupil_in_map = 0.33f;
    config.virtual_cornea = 0.0f;
    config.cornea_roughness_deg = 0.4f;
    config.sclera_roughness_deg = 6.0f;
    config.sclera_normal_strength = 1.0f;
    config.meniscus_height_mm = 0.2f;
    config.iris_height_mm = 0.0f;
    return config;
}

SKINSHADE_FUNCTION skinshade_result skinshade_pack_eye(
    const skinshade_eye_config *config, void *bytes, size_t size)
{
    unsigned char *block = (unsigned char *)bytes;
    skinshade_error error;
    if (config == NULL || bytes == NULL)
        return skinshade_result_of(SKINSHADE_NULL_POINTER, NULL);
    if (size < SKINSHADE_EYE_BLOCK_SIZE)
        return skinshade_result_of(SKINSHADE_BUFFER_TOO_SMALL, NULL);
    error = skinshade_check(config->iris_uv, 4, -16.0, 16.0);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "iris_uv");
    error = skinshade_check(&config->sclera_radius_mm, 1, 8.0, 16.0);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "sclera_radius_mm");
    error = skinshade_check(&config->limbus_radius_mm, 1, 4.0, 8.0);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "limbus_radius_mm");
    error = skinshade_check(&config->limbus_width_mm, 1, 0.1, 1.5);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "limbus_width_mm");
    error = skinshade_check(&config->cornea_radius_mm, 1, 6.0, 10.0);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "cornea_radius_mm");
    error = skinshade_check(&config->cornea_asphericity, 1, -0.8, 0.3);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "cornea_asphericity");
    error = skinshade_check(&config->refraction_index, 1, 1.0, 1.6);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "refraction_index");
    error = skinshade_check(&config->tear_index, 1, 1.0, 1.6);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "tear_index");
    error = skinshade_check(&config->aqueous_index, 1, 1.0, 1.6);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "aqueous_index");
    error = skinshade_check(&config->iris_depth_mm, 1, 1.0, 6.0);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "iris_depth_mm");
    error = skinshade_check(&config->iris_slope, 1, -0.3, 0.3);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "iris_slope");
    error = skinshade_check(&config->iris_radius_mm, 1, 3.0, 8.0);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "iris_radius_mm");
    error = skinshade_check(&config->pupil_radius_mm, 1, 0.5, 4.5);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "pupil_radius_mm");
    error = skinshade_check(&config->pupil_in_map, 1, 0.0, 0.9);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "pupil_in_map");
    error = skinshade_check(&config->virtual_cornea, 1, 0.0, 1.0);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "virtual_cornea");
    error = skinshade_check(&config->cornea_roughness_deg, 1, 0.1, 10.0);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "cornea_roughness_deg");
    error = skinshade_check(&config->sclera_roughness_deg, 1, 1.0, 20.0);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "sclera_roughness_deg");
    error = skinshade_check(&config->sclera_normal_strength, 1, 0.0, 2.0);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "sclera_normal_strength");
    error = skinshade_check(&config->meniscus_height_mm, 1, 0.0, 0.7);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "meniscus_height_mm");
    error = skinshade_check(&config->iris_height_mm, 1, 0.0, 0.3);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "iris_height_mm");
    memset(block, 0, SKINSHADE_EYE_BLOCK_SIZE);
    memcpy(block + 0, config->iris_uv, 16);
    memcpy(block + 16, &config->sclera_radius_mm, 4);
    memcpy(block + 20, &config->limbus_radius_mm, 4);
    memcpy(block + 24, &config->limbus_width_mm, 4);
    memcpy(block + 28, &config->cornea_radius_mm, 4);
    memcpy(block + 32, &config->cornea_asphericity, 4);
    memcpy(block + 36, &config->refraction_index, 4);
    memcpy(block + 40, &config->tear_index, 4);
    memcpy(block + 44, &config->aqueous_index, 4);
    memcpy(block + 48, &config->iris_depth_mm, 4);
    memcpy(block + 52, &config->iris_slope, 4);
    memcpy(block + 56, &config->iris_radius_mm, 4);
    memcpy(block + 60, &config->pupil_radius_mm, 4);
    memcpy(block + 64, &config->pupil_in_map, 4);
    memcpy(block + 68, &config->virtual_cornea, 4);
    memcpy(block + 72, &config->cornea_roughness_deg, 4);
    memcpy(block + 76, &config->sclera_roughness_deg, 4);
    memcpy(block + 80, &config->sclera_normal_strength, 4);
    memcpy(block + 84, &config->meniscus_height_mm, 4);
    memcpy(block + 88, &config->iris_height_mm, 4);
    return skinshade_result_of(SKINSHADE_OK, NULL);
}

#define SKINSHADE_EYE_PLACE_BLOCK_SIZE 144

typedef struct skinshade_eye_place_config {
    float eye_x[4]; /* -1e+30..1e+30. Row x of the matrix from the world to mm of the eye. */
    float eye_y[4]; /* -1e+30..1e+30. Row y of the matrix from the world to mm of the eye. */
    float eye_z[4]; /* -1e+30..1e+30. Row z of the matrix from the world to mm of the eye. */
    float lid_upper[4]; /* -100..100. Plane n, D (mm) that the upper lid lies beyond. */
    float lid_lower[4]; /* -100..100. Plane n, D (mm) that the lower lid lies beyond. */
    float lamp_axes[4]; /* -1e+06..1e+06. Axes of the table of a lamp: low and 1/(high - low) of the columns, mm, then of the rows. */
    float surroundings_axes[4]; /* -1e+06..1e+06. Axes of the table of the surroundings: low and 1/(high - low) of the columns, mm, then of the rows. */
    float lid_radiance[3]; /* 0..1e+30. Radiance of the inner sides of the lids. */
    float lid_radius_mm; /* 8..30 mm. Radius of the ball whose surface is the outer side of the lids. */
} skinshade_eye_place_config;

SKINSHADE_FUNCTION skinshade_eye_place_config skinshade_eye_place_defaults(void)
{
    skinshade_eye_place_config config;
    config.eye_x[0] = 1.0f;
    config.eye_x[1] = 0.0f;
    config.eye_x[2] = 0.0f;
    config.eye_x[3] = 0.0f;
    config.eye_y[0] = 0.0f;
    config.eye_y[1] = 1.0f;
    config.eye_y[2] = 0.0f;
    config.eye_y[3] = 0.0f;
    config.eye_z[0] = 0.0f;
    config.eye_z[1] = 0.0f;
    config.eye_z[2] = 1.0f;
    config.eye_z[3] = 0.0f;
    config.lid_upper[0] = 0.0f;
    config.lid_upper[1] = 0.8659855571062421f;
    config.lid_upper[2] = -0.5000690101209946f;
    config.lid_upper[3] = -2.2503105455444756f;
    config.lid_lower[0] = 0.0f;
    config.lid_lower[1] = -0.7661202769080395f;
    config.lid_lower[2] = -0.6426972236678394f;
    config.lid_lower[3] = -2.8921375065052777f;
    config.lamp_axes[0] = -6.193548387096774f;
    config.lamp_axes[1] = 0.08072916666666667f;
    config.lamp_axes[2] = 0.0f;
    config.lamp_axes[3] = 0.00390625f;
    config.surroundings_axes[0] = -0.0967741935483871f;
    config.surroundings_axes[1] = 0.16145833333333334f;
    config.surroundings_axes[2] = -0.5f;
    config.surroundings_axes[3] = 0.5f;
    config.lid_radiance[0] = 0.0f;
    config.lid_radiance[1] = 0.0f;
    config.lid_radiance[2] = 0.0f;
    config.lid_radius_mm = 14.2f;
    return config;
}

SKINSHADE_FUNCTION skinshade_result skinshade_pack_eye_place(
    const skinshade_eye_place_config *config, void *bytes, size_t size)
{
    unsigned char *block = (unsigned char *)bytes;
    skinshade_error error;
    if (config == NULL || bytes == NULL)
        return skinshade_result_of(SKINSHADE_NULL_POINTER, NULL);
    if (size < SKINSHADE_EYE_PLACE_BLOCK_SIZE)
        return skinshade_result_of(SKINSHADE_BUFFER_TOO_SMALL, NULL);
    error = skinshade_check(config->eye_x, 4, -1e+30, 1e+30);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "eye_x");
    error = skinshade_check(config->eye_y, 4, -1e+30, 1e+30);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "eye_y");
    error = skinshade_check(config->eye_z, 4, -1e+30, 1e+30);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "eye_z");
    error = skinshade_check(config->lid_upper, 4, -100.0, 100.0);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "lid_upper");
    error = skinshade_check(config->lid_lower, 4, -100.0, 100.0);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "lid_lower");
    error = skinshade_check(config->lamp_axes, 4, -1000000.0, 1000000.0);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "lamp_axes");
    error = skinshade_check(config->surroundings_axes, 4, -1000000.0, 1000000.0);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "surroundings_axes");
    error = skinshade_check(config->lid_radiance, 3, 0.0, 1e+30);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "lid_radiance");
    error = skinshade_check(&config->lid_radius_mm, 1, 8.0, 30.0);
    if (error != SKINSHADE_OK)
        return skinshade_result_of(error, "lid_radius_mm");
    memset(block, 0, SKINSHADE_EYE_PLACE_BLOCK_SIZE);
    memcpy(block + 0, config->eye_x, 16);
    memcpy(block + 16, config->eye_y, 16);
    memcpy(block + 32, config->eye_z, 16);
    memcpy(block + 48, config->lid_upper, 16);
    memcpy(block + 64, config->lid_lower, 16);
    memcpy(block + 80, config->lamp_axes, 16);
    memcpy(block + 96, config->surroundings_axes, 16);
    memcpy(block + 112, config->lid_radiance, 12);
    memcpy(block + 128, &config->lid_radius_mm, 4);
    return skinshade_result_of(SKINSHADE_OK, NULL);
}

#ifdef __cplusplus
}
#endif

#endif
