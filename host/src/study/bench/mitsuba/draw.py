import sys
import time

try:
    import mitsuba as mi
except ImportError:
    sys.exit("the module mitsuba is not installed: python3 -m pip install mitsuba")

mi.set_variant("scalar_rgb")
mi.set_log_level(mi.LogLevel.Error)


def rgb(color):
    return {"type": "rgb", "value": color}


def mesh(name, triangles):
    # A file, since a mesh in memory takes another way for each version.
    with open(name, "w") as file:
        for vertices in triangles:
            for x, y, z in vertices:
                file.write(f"v {x!r} {y!r} {z!r}\n")
        for first in range(1, 3 * len(triangles), 3):
            file.write(f"f {first} {first + 1} {first + 2}\n")
    return {"type": "obj", "filename": name, "face_normals": True}


# All triangles of one look are one mesh.
meshes = {}
for vertices, color, emits in TRIANGLES:
    meshes.setdefault((tuple(color), tuple(emits)), []).append(vertices)
scene = {
    "type": "scene",
    "integrator": {"type": "path"},
    "sensor": {
        "type": "perspective",
        "fov": FOV,
        "fov_axis": "y",
        "to_world": mi.ScalarTransform4f().look_at(EYE, TARGET, UP),
        "film": {
            "type": "hdrfilm",
            "width": WIDTH,
            "height": HEIGHT,
            "rfilter": {"type": "box"},
            "pixel_format": "rgb",
            "component_format": "float32",
        },
        "sampler": {"type": "independent"},
    },
}
if any(SKY):
    scene["sky"] = {"type": "constant", "radiance": rgb(SKY)}
for number, ((color, emits), triangles) in enumerate(meshes.items()):
    shape = mesh(f"mesh-{number}.obj", triangles)
    shape["bsdf"] = {"type": "diffuse", "reflectance": rgb(list(color))}
    if any(emits):
        shape["emitter"] = {"type": "area", "radiance": rgb(list(emits))}
    scene[f"mesh-{number}"] = shape
scene = mi.load_dict(scene)
mi.render(scene, spp=1)
for samples in SAMPLES:
    start = time.process_time()
    picture = mi.render(scene, spp=samples, seed=int(sys.argv[1]))
    seconds = time.process_time() - start
    mi.Bitmap(picture).write(f"theirs-{samples}.pfm")
    print(samples, seconds)
