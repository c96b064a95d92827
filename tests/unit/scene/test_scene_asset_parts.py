"""Materials of glTF heads: which are skin, and their maps."""

import base64
import json
import re
import warnings

import numpy as np
import pytest

import gltf_shapes
from skinshade._core.errors import ArgumentError, AssetWarning, MeshFileError
from skinshade._core.pixels import write_pixels
from skinshade.gltf.materials import GltfMaterial
from skinshade.heads import load_head
from skinshade.params import SkinParams
from skinshade.scene import Material, load_scene
from skinshade.scene.asset_parts import skin_materials

ASSETS = [
    (["Wolf3D_Skin", "Wolf3D_Hair", "Wolf3D_Eye", "Wolf3D_Outfit_Top"], [0]),
    (["Material.002"], [0]),
    ([""], [0]),
    (["Head_MAT", "Body_MAT", "Eyes", "Eyelash", "Tongue", "Teeth"], [0, 1]),
    (["Std_Skin_Head", "Std_Skin_Arm", "Std_Nails", "Std_Cornea_L", "Scalp_Transparency"], [0, 1]),
    (["lambert1", "Glasses", "Beard"], [0]),
    (["FACE", "HAIR", "Headphones"], [0]),
    (["Hair", "Eyeball"], []),
]


@pytest.mark.parametrize(("names", "skin"), ASSETS)
def test_skin_is_recognised_by_the_names_of_common_exporters(names, skin):
    materials = {index: GltfMaterial(name) for index, name in enumerate(names)}
    assert skin_materials(materials) == skin


@pytest.mark.parametrize("mode", ["MASK", "BLEND"])
def test_transparent_materials_are_not_skin_unless_they_are_named(mode):
    materials = {0: GltfMaterial("a"), 1: GltfMaterial("b skin", alpha_mode=mode)}
    assert skin_materials(materials) == [0]
    assert skin_materials(materials, ["B *"]) == [1]


def test_an_unknown_name_is_refused_with_the_names_of_the_asset():
    with pytest.raises(ArgumentError, match=r"'skn': there is none; there are 'a'"):
        skin_materials({0: GltfMaterial("a")}, ["skn"])


def png(tmp_path, pixels):
    path = tmp_path / "texture.png"
    write_pixels(path, np.asarray(pixels, dtype=np.uint8))
    return path.read_bytes()


def face(tmp_path, image=None, **hair):
    """Write a head of two spheres with the materials Skin and Hair; return its path."""
    model = gltf_shapes.several_primitives()
    model.document["materials"] = [
        {"name": "Skin", "pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.25, 0.125, 1.0]}},
        {"name": "Hair", "pbrMetallicRoughness": {"roughnessFactor": 0.3}} | hair,
    ]
    for mesh in model.document["meshes"]:
        for number, primitive in enumerate(mesh["primitives"]):
            primitive["material"] = min(number, 1)
    if image is not None:
        view = model.add_view(image)
        model.document["images"] = [{"bufferView": view, "mimeType": "image/png"}]
        model.document["textures"] = [{"source": 0}]
    return gltf_shapes.write(model, tmp_path, stem="face")


def test_colour_and_roughness_of_both_materials_are_read(tmp_path):
    head = load_head(face(tmp_path))
    assert head.material.name == "Skin"
    np.testing.assert_allclose(head.material.albedo, [[[0.5, 0.25, 0.125]]])
    (hair,) = head.parts
    assert (hair.name, hair.is_skin) == ("Hair", False)
    assert hair.material.params.gloss == SkinParams(roughness=0.3).gloss


def test_a_file_without_a_stated_roughness_keeps_the_gloss_of_skin(tmp_path):
    assert load_head(face(tmp_path)).material.params.gloss == SkinParams().gloss


def test_skin_without_a_stated_colour_has_the_default_colour(tmp_path):
    path = face(tmp_path)
    document, binary = gltf_shapes.read(path)
    document["materials"][0].pop("pbrMetallicRoughness")
    path.write_bytes(gltf_shapes.pack_glb(document, binary[0]))
    np.testing.assert_array_equal(load_head(path).material.albedo, Material().albedo)


def test_the_names_of_skin_can_be_given(tmp_path):
    head = load_head(face(tmp_path), skin_material=["hair"])
    assert head.material.name == "Hair"
    assert [(part.name, part.is_skin) for part in head.parts] == [("Skin", False)]


def test_an_asset_without_skin_is_refused_with_its_materials(tmp_path):
    path = face(tmp_path)
    text = path.read_bytes().replace(b'"Skin"', b'"Iris"')
    path.write_bytes(text)
    with pytest.raises(ArgumentError, match=r"looks like skin: .*'Iris'.*--skin-material"):
        load_head(path)


def test_opacity_of_a_map_is_read_with_its_cutoff(tmp_path):
    pixels = np.zeros((2, 2, 4))
    pixels[..., 0], pixels[..., 3] = 255, [[0, 51], [102, 255]]
    surface = {"baseColorTexture": {"index": 0}, "baseColorFactor": [1, 1, 1, 0.5]}
    head = load_head(
        face(tmp_path, png(tmp_path, pixels), alphaMode="MASK", alphaCutoff=0.3,
             pbrMetallicRoughness=surface)
    )  # fmt: skip
    (hair,) = head.parts
    np.testing.assert_allclose(hair.opacity[..., 0], [[0.0, 0.1], [0.2, 0.5]], atol=1e-6)
    np.testing.assert_allclose(hair.material.albedo, np.broadcast_to([1, 0, 0], (2, 2, 3)))
    assert hair.opacity_cutoff == pytest.approx(0.3)


@pytest.mark.parametrize("image", [b"not an image", gltf_shapes.PNG[:40]])
def test_an_image_that_cannot_be_read_is_left_out_with_a_warning(tmp_path, image):
    surface = {"baseColorTexture": {"index": 0}, "baseColorFactor": [0.2, 0.3, 0.4, 1]}
    path = face(tmp_path, image, pbrMetallicRoughness=surface)
    with pytest.warns(AssetWarning, match=re.escape(f"{path}: image 0 is left out: ")):
        head = load_head(path)
    np.testing.assert_allclose(head.parts[0].material.albedo, [[[0.2, 0.3, 0.4]]], rtol=1e-6)


@pytest.mark.parametrize(
    "surface",
    [
        {"baseColorFactor": "red"},
        {"baseColorFactor": [1, None, float("1e30"), -5]},
        {"roughnessFactor": [1]},
        {"baseColorTexture": 5},
        {"baseColorTexture": {"index": 0, "texCoord": 1}},
        7,
    ],
)
def test_malformed_values_are_those_of_a_material_without_them(tmp_path, surface):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        head = load_head(face(tmp_path, gltf_shapes.PNG, pbrMetallicRoughness=surface))
    albedo = head.parts[0].material.albedo
    assert albedo.shape == (1, 1, 3)
    assert np.isfinite(albedo).all()
    assert ((albedo >= 0.0) & (albedo <= 1.0)).all()


@pytest.mark.parametrize(
    ("change", "complaint"),
    [
        ({"materials": []}, "refers to materials 0"),
        ({"textures": []}, "refers to textures 0"),
        ({"images": []}, "refers to images 0"),
    ],
)
def test_a_reference_to_nothing_is_an_error(tmp_path, change, complaint):
    surface = {"baseColorTexture": {"index": 0}}
    path = face(tmp_path, gltf_shapes.PNG, pbrMetallicRoughness=surface)
    document, binary = gltf_shapes.read(path)
    path.write_bytes(gltf_shapes.pack_glb(document | change, binary[0]))
    with pytest.raises(MeshFileError, match=complaint):
        load_head(path)


def test_a_data_uri_and_a_transform_of_texture_coordinates_are_read(tmp_path):
    path = face(tmp_path, pbrMetallicRoughness={
        "baseColorTexture": {
            "index": 0,
            "extensions": {"KHR_texture_transform": {"scale": [2.0, 0.5], "offset": [0.25, 0.0]}},
        }
    })  # fmt: skip
    document, binary = gltf_shapes.read(path)
    uri = "data:image/png;base64," + base64.b64encode(gltf_shapes.PNG).decode()
    document |= {"images": [{"uri": uri}], "textures": [{"source": 0}]}
    path.write_bytes(gltf_shapes.pack_glb(document, binary[0]))
    plain = load_head(face(tmp_path / "plain"))
    head = load_head(path)
    hair = np.unique(head.mesh.faces[head.mesh.materials == 1])
    skin = np.setdiff1d(np.unique(head.mesh.faces), hair)
    np.testing.assert_array_equal(head.mesh.uvs[skin], plain.mesh.uvs[skin])
    expected = plain.mesh.uvs[hair] * (2.0, 0.5) + (0.25, 0.0)
    np.testing.assert_allclose(head.mesh.uvs[hair], expected)


def test_a_model_whose_v_is_flipped_keeps_the_look_of_its_own_maps(tmp_path):
    pixels = np.arange(2 * 2 * 4).reshape(2, 2, 4) * 10
    surface = {"baseColorTexture": {"index": 0}}
    path = face(tmp_path, png(tmp_path, pixels), alphaMode="MASK", pbrMetallicRoughness=surface)
    plain, flipped = load_head(path), load_head(path, flip_v=True)
    np.testing.assert_allclose(flipped.mesh.uvs, plain.mesh.uvs * (1, -1) + (0, 1))
    one, other = plain.parts[0], flipped.parts[0]
    np.testing.assert_array_equal(other.material.albedo, one.material.albedo[::-1])
    np.testing.assert_array_equal(other.opacity, one.opacity[::-1])


def test_a_scene_file_uses_the_materials_of_its_model(tmp_path):
    face(tmp_path)
    description = {
        "skinshade": 1,
        "mesh": {"path": "face.glb"},
        "camera": {"position": [0, 0, 0.9], "target": [0, 0, 0]},
        "material": {"gloss": 0.7},
    }
    scenes = []
    for names in ([], ["Hair"]):
        description["mesh"]["skin_materials"] = names
        (tmp_path / "scene.json").write_text(json.dumps(description))
        scenes.append(load_scene(tmp_path / "scene.json"))
    assert [[part.name for part in scene.parts] for scene in scenes] == [["Hair"], ["Skin"]]
    assert [scene.material.params.gloss for scene in scenes] == [0.7, 0.7]
    assert [part.is_skin for scene in scenes for part in scene.parts] == [False, False]
