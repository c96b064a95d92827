// Sum over lights, which replaces that of pygfx's fragment shader.
    var material: SkinSurface;
    material.position = geometry.position;
    material.view = view;
    material.mesh_normal = surface_normal;
    material.gloss = u_skin.gloss;
    material.reflectance = u_skin.reflectance * specular_strength;
    {
        // Seen from inside, a convex body is concave.
        let per_mm = face_direction / skinshade_scale();
        material.curvature_per_mm = per_mm * varyings.texcoord100;
        $$ if skin_tier == "tensor"
        material.tensor = skinshade_tensor(varyings.texcoord102, varyings.texcoord103);
        $$ endif
        var fetched = mat3x3<f32>(surface_normal, surface_normal, surface_normal);
        $$ if use_normal_map is defined
        fetched = skinshade_fetch(normal_map_uv, tbn);
        material.gloss = skin_gloss_of_relief(material.gloss, skin_safe_length(fetched[0]));
        $$ endif
        material.sharp = skin_unit_vectors(fetched[0]);
        material.blurred = skin_unit_vectors(fetched[2]);
        material.normals = skin_blend_normals(fetched, skinshade_blend());
        material.gain = skin_energy_gain(
            u_scatter.albedo.xyz, u_scatter.rms_radius_mm.xyz, per_mm * varyings.texcoord101);
        material.albedo = skinshade_body(material, physical_albedo);
    }
    $$ for kind, lights, title, count in [("point", "point", "Point", num_point_lights), ("spot", "spot", "Spot", num_spot_lights), ("dir", "directional", "Directional", num_dir_lights)]
    $$ if count > 0
    for (var i = 0; i < {{ count }}; i++) {
        let source = u_{{ lights }}_lights[i];
        let incoming = get{{ title }}LightInfo(source, geometry);
        if (!incoming.visible) {
            continue;
        }
        let cosine = dot(material.mesh_normal, incoming.direction);
        var light = SkinIncident(incoming.direction, incoming.color * RECIPROCAL_PI, 0.0, 1e3);
        if (cosine > {{ skin_dark_beyond }}) {
            light.shadow_filter = 1.0;
        }
        $$ if receive_shadow
        if (source.cast_shadow != 0) {
            $$ if kind == "point"
            if (cosine > {{ skin_dark_beyond }}) {
                light.shadow_filter = skinshade_filter_cube(i, source, material, incoming.direction);
            }
            $$ else
            if (cosine > {{ skin_dark_beyond }}) {
                light.shadow_filter = skinshade_filter(
                    u_shadow_map_{{ kind }}_light, i, source.light_view_proj_matrix, material, incoming.direction);
            }
            $$ if skin_taps > 0
            // No light comes through where the blurred normal faces the light.
            if (cosine < 0.5 && dot(material.blurred, incoming.direction) < 0.0) {
                light.thickness_mm = skinshade_thickness(
                    u_shadow_map_{{ kind }}_light, i, source.light_view_proj_matrix, material);
            }
            $$ endif
            $$ endif
        }
        $$ endif
        skinshade_add(light, material, &reflected_light);
    }
    $$ endif
    $$ endfor
