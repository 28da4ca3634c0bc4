#!/usr/bin/env python3
"""Writes tests/io/orientation/fixtures: one small block in every format of orientations, and what
its cameras see.

It shares nothing with the program: no library, formulas of its own. Angles are large, principal
points lie off the middle, lenses distort, and names have blanks and umlauts. `observations.csv` has
image, X, Y, Z in the block's map and column, row, where pixel (0, 0) is the centre of the top-left
pixel; `observations_utm.csv` the same in UTM zone 32N with heights above the ellipsoid, for the
formats with topocentric or geocentric coordinates.

Usage: make_fixtures.py FOLDER
"""
import json
import math
import os
import random
import sys

WIDTH, HEIGHT, FOCAL = 1200, 900, 1300.0
OFFSET = (17.25, -11.5)  # principal point from the middle of the image, right and down
K1, K2, K3, P1, P2 = -0.061, 0.023, -0.004, 0.0011, -0.0007  # as OpenCV has them
ORIGIN = (500321.0, 5412345.0, 0.0)
NAMES = ["a b_1.tif", "Höhe 2.tif", "3.tif", "strip 4.tif"]
# omega, phi, kappa in degrees; positions in the block, z is the height
POSES = [((24.0, -13.0, 37.0), (-18.0, -42.0, 96.0)), ((-21.0, 15.5, 141.0), (22.0, 36.0, 101.0)),
         ((9.0, 27.0, -88.0), (47.0, -16.0, 99.0)), ((-6.0, -22.0, -163.0), (-41.0, 12.0, 103.0))]
LAT, LON = 48.4, 11.44  # 2.44 degrees off the central meridian: the plan is true to scale there
A, F = 6378137.0, 1.0 / 298.257223563


def mul(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]


def apply(a, v):
    return [sum(a[i][k] * v[k] for k in range(3)) for i in range(3)]


def transposed(a):
    return [[a[j][i] for j in range(3)] for i in range(3)]


def turn(axis, deg):
    c, s = math.cos(math.radians(deg)), math.sin(math.radians(deg))
    return {"x": [[1, 0, 0], [0, c, -s], [0, s, c]], "y": [[c, 0, s], [0, 1, 0], [-s, 0, c]],
            "z": [[c, -s, 0], [s, c, 0], [0, 0, 1]]}[axis]


def world_from_camera(angles):
    return mul(mul(turn("x", angles[0]), turn("y", angles[1])), turn("z", angles[2]))


def seen(angles, centre, point):
    """Column and row, and the distance in front of the camera."""
    v = apply(transposed(world_from_camera(angles)), [p - c for p, c in zip(point, centre)])
    x, y = v[0] / -v[2], -v[1] / -v[2]
    r2 = x * x + y * y
    radial = 1 + K1 * r2 + K2 * r2 ** 2 + K3 * r2 ** 3
    xd = x * radial + 2 * P1 * x * y + P2 * (r2 + 2 * x * x)
    yd = y * radial + P1 * (r2 + 2 * y * y) + 2 * P2 * x * y
    return (FOCAL * xd + (WIDTH - 1) / 2 + OFFSET[0], FOCAL * yd + (HEIGHT - 1) / 2 + OFFSET[1], -v[2])


def enu_axes():
    la, lo = math.radians(LAT), math.radians(LON)
    return [[-math.sin(lo), -math.sin(la) * math.cos(lo), math.cos(la) * math.cos(lo)],
            [math.cos(lo), -math.sin(la) * math.sin(lo), math.cos(la) * math.sin(lo)],
            [0, math.cos(la), math.sin(la)]]


def geocentric(point):
    """Of a point in the topocentric frame at LAT, LON, height 0."""
    e2 = F * (2 - F)
    la, lo = math.radians(LAT), math.radians(LON)
    n = A / math.sqrt(1 - e2 * math.sin(la) ** 2)
    origin = [n * math.cos(la) * math.cos(lo), n * math.cos(la) * math.sin(lo), n * (1 - e2) * math.sin(la)]
    return [o + d for o, d in zip(origin, apply(enu_axes(), point))]


def utm32(x):
    """Easting, northing, height above the ellipsoid: latitude by iteration, then Krueger's series
    to the fourth order.
    """
    e2 = F * (2 - F)
    p = math.hypot(x[0], x[1])
    la = math.atan2(x[2], p * (1 - e2))
    for _ in range(20):
        n = A / math.sqrt(1 - e2 * math.sin(la) ** 2)
        la = math.atan2(x[2] + e2 * n * math.sin(la), p)
    h = p / math.cos(la) - A / math.sqrt(1 - e2 * math.sin(la) ** 2)
    lo = math.atan2(x[1], x[0]) - math.radians(9)
    n = F / (2 - F)
    radius = A / (1 + n) * (1 + n ** 2 / 4 + n ** 4 / 64)
    alpha = [n / 2 - 2 * n ** 2 / 3 + 5 * n ** 3 / 16 + 41 * n ** 4 / 180, 13 * n ** 2 / 48 - 3 * n ** 3 / 5 + 557 * n ** 4 / 1440,
             61 * n ** 3 / 240 - 103 * n ** 4 / 140, 49561 * n ** 4 / 161280]
    c = 2 * math.sqrt(n) / (1 + n)
    t = math.sinh(math.atanh(math.sin(la)) - c * math.atanh(c * math.sin(la)))
    xi, eta = math.atan2(t, math.cos(lo)), math.atanh(math.sin(lo) / math.sqrt(1 + t * t))
    east = eta + sum(a * math.cos(2 * j * xi) * math.sinh(2 * j * eta) for j, a in enumerate(alpha, 1))
    north = xi + sum(a * math.sin(2 * j * xi) * math.cosh(2 * j * eta) for j, a in enumerate(alpha, 1))
    return [500000 + 0.9996 * radius * east, 0.9996 * radius * north, h]


def flat(matrix):
    return " ".join(f"{v:.15f}" for row in matrix for v in row)


def on_map(centre):
    return [c + o for c, o in zip(centre, ORIGIN)]


class Writer:
    def __init__(self, folder):
        self.folder = folder
        os.makedirs(folder, exist_ok=True)

    def write(self, name, text):
        with open(os.path.join(self.folder, name), "w", encoding="utf-8") as file:
            file.write(text)


def write_observations(out):
    rng = random.Random(38)
    rows, utm_rows = ["point,image,x,y,z,column_px,row_px"], ["point,image,x,y,z,column_px,row_px"]
    for point in range(60):
        x = [rng.uniform(-60, 60), rng.uniform(-60, 60), rng.uniform(0, 12)]
        for name, (angles, centre) in zip(NAMES, POSES):
            column, row, depth = seen(angles, centre, x)
            if depth <= 0 or not (0 <= column < WIDTH and 0 <= row < HEIGHT):
                continue
            pixel = f"{column:.9f},{row:.9f}"
            rows.append(f"{point},{name}," + ",".join(f"{v:.9f}" for v in on_map(x)) + "," + pixel)
            utm_rows.append(f"{point},{name}," + ",".join(f"{v:.9f}" for v in utm32(geocentric(x))) + "," + pixel)
    out.write("observations.csv", "\n".join(rows) + "\n")
    out.write("observations_utm.csv", "\n".join(utm_rows) + "\n")


def write_tables(out):
    units = {"deg": 1.0, "gon": 400 / 360, "rad": math.pi / 180}
    for unit, factor in units.items():
        head = "# angles in gon (grad)\n" if unit == "gon" else ""
        head += {"deg": "filename,x,y,z,omega_deg,phi_deg,kappa_deg,camera",
                 "gon": "Label;Easting [m];Northing [m];Altitude [m];Omega;Phi;Kappa;Camera",
                 "rad": "'name' 'X' 'Y' 'Z' 'O' 'P' 'K' 'camera'"}[unit]
        separator = {"deg": ",", "gon": ";", "rad": " "}[unit]
        rows = [head]
        for name, (angles, centre) in zip(NAMES, POSES):
            fields = [f"'{name}'" if unit == "rad" else name]
            fields += [f"{v:.6f}" for v in on_map(centre)] + [f"{a * factor:.15g}" for a in angles]
            rows.append(separator.join(fields + ["'cam 1'" if unit == "rad" else "cam 1"]))
        out.write(f"opk_{unit}.csv", "\n".join(rows) + "\n")
    out.write("opk_bare.txt", "".join(
        f"{name} " + " ".join(f"{v:.6f}" for v in on_map(centre)) + " " + " ".join(f"{a:.12f}" for a in angles) + "\n"
        for name, (angles, centre) in zip(NAMES, POSES)))
    side = max(WIDTH, HEIGHT)
    out.write("cameras.yaml", "cam 1:\n  type: brown\n" + f"  im_size: [{WIDTH}, {HEIGHT}]\n  focal_len: {FOCAL * 6 / 1000}\n"
              f"  sensor_size: [{WIDTH * 6 / 1000}, {HEIGHT * 6 / 1000}]\n  cx: {OFFSET[0] / side:.17g}\n  cy: {OFFSET[1] / side:.17g}\n"
              f"  k1: {K1}\n  k2: {K2}\n  k3: {K3}\n  p1: {P1}\n  p2: {P2}\n")
    out.write("cameras_mm.yaml", f"cam 1:\n  focal_length_mm: {FOCAL * 6 / 1000}\n  pixel_size_um: 6\n  size_px: [{WIDTH}, {HEIGHT}]\n"
              f"  principal_point_mm: [{OFFSET[0] * 6 / 1000:.15g}, {-OFFSET[1] * 6 / 1000:.15g}]\n"
              f"  k1: {K1}\n  k2: {K2}\n  k3: {K3}\n  p1: {P1}\n  p2: {P2}\n")


def write_pat_b(out):
    for name, direction in (("world_from_camera", lambda m: m), ("camera_from_world", transposed)):
        text = ""
        for i, (angles, centre) in enumerate(POSES):
            x, m = on_map(centre), [v for row in direction(world_from_camera(angles)) for v in row]
            text += f"{i + 1:>16}{'':16}" + "".join(f"{v:16.5f}" for v in x) + "\n"
            text += "".join(f"{v:16.12f}" for v in m[:5]) + "\n" + "".join(f"{v:16.12f}" for v in m[5:]) + "\n"
        out.write(f"pat_b_{name}.ori", text)


def write_inpho(out, turned):
    """`turned`: the camera's axes lie a quarter turn off the image's, as where a camera is built in
    across.
    """
    per_mm = 1000 / 6
    quarter = turn("z", 90)  # camera axes in ours: x points up in the image
    matrix = [[0.0, -per_mm], [-per_mm, 0.0]] if turned else [[per_mm, 0.0], [0.0, -per_mm]]
    ppa = [OFFSET[0] / per_mm, -OFFSET[1] / per_mm]
    if turned:
        ppa = apply(transposed(quarter), ppa + [0])[:2]
    text = "$PROJECT 6.0.0\n  $PROJECT_NAME : fixture\n  $LINEAR_UNITS_OF_OBJECT : m\n  $ANGULAR_UNITS : deg\n$END\n"
    text += "$CAMERA_DEFINITION\n  $ID : cam 1\n" + f"  $CCD_COLUMNS : {WIDTH}\n  $CCD_ROWS : {HEIGHT}\n"
    text += "  $PIXEL_REFERENCE : CenterTopLeft\n  $CAMERA_MOUNT_ROTATION : 90\n  $ACTIVE_CALIBRATION : 2\n"
    text += "  $CALIBRATION_SET :\n    $ID : 1\n    $CCD_INTERIOR_ORIENTATION :\n      10 0 0\n      0 -10 0\n"
    text += "    $FOCAL_LENGTH : 50\n    $PRINCIPAL_POINT_PPA : 0 0\n  $END\n"
    text += "  $CALIBRATION_SET :\n    $ID : 2\n    $CCD_INTERIOR_ORIENTATION :\n"
    text += f"      {matrix[0][0]:.15f} {matrix[0][1]:.15f} {(WIDTH - 1) / 2}\n      {matrix[1][0]:.15f} {matrix[1][1]:.15f} {(HEIGHT - 1) / 2}\n"
    text += f"    $FOCAL_LENGTH : {FOCAL / per_mm:.15f}\n    $PRINCIPAL_POINT_PPA : {ppa[0]:.15f} {ppa[1]:.15f}\n  $END\n$END\n"
    for i, (name, (angles, centre)) in enumerate(zip(NAMES, POSES)):
        m = world_from_camera(angles)
        if turned:
            m = mul(m, quarter)
        m, x = transposed(m), on_map(centre)
        text += f"$PHOTO\n  $PHOTO_NUM : {i + 1}\n  $PHOTO_FILE : D:\\flight 1\\{name}\n  $CAMERA_ID : cam 1\n  $TERRAIN_HEIGHT : 6.0\n"
        text += f"  $EXT_ORI : 12:00:00 01/01/2026\n    {FOCAL / per_mm:.6f} " + " ".join(f"{v:.6f}" for v in x) + "\n"
        text += "".join("    " + " ".join(f"{v:.15f}" for v in row) + "\n" for row in m) + "$END\n"
    out.write("inpho_turned.prj" if turned else "inpho.prj", text)


# in the image, right and down: where the camera's axes x and y point
AXES = {"XRightYDown": ((1, 0), (0, 1)), "XRightYUp": ((1, 0), (0, -1)), "XLeftYDown": ((-1, 0), (0, 1)), "XLeftYUp": ((-1, 0), (0, -1)),
        "XDownYRight": ((0, 1), (1, 0)), "XDownYLeft": ((0, 1), (-1, 0)), "XUpYRight": ((0, -1), (1, 0)), "XUpYLeft": ((0, -1), (-1, 0))}


def write_blocks_exchange(out, name, orientation, srs, centre_of, with_angles=False, world_axes=None):
    (xr, xd), (yr, yd) = AXES[orientation]
    axes = [[xr, yr, 0], [-xd, -yd, 0], [0, 0, 0]]  # columns: in axes right, up, backwards
    axes[2][2] = xr * -yd - yr * -xd
    photos = ""
    for i, (image, (angles, centre)) in enumerate(zip(NAMES, POSES)):
        m = transposed(mul(world_from_camera(angles), axes))
        if world_axes:
            m = mul(m, transposed(world_axes))
        if with_angles:
            rotation = f"<Omega>{angles[0]}</Omega><Phi>{angles[1]}</Phi><Kappa>{angles[2]}</Kappa>"
        else:
            rotation = "".join(f"<M_{r}{c}>{m[r][c]:.15f}</M_{r}{c}>" for r in range(3) for c in range(3))
        x, y, z = centre_of(centre)
        photos += f"""
      <Photo><Id>{i}</Id><ImagePath>D:/flight 1/{image}</ImagePath><Component>1</Component>
        <Pose><Rotation>{rotation}<Accurate>true</Accurate></Rotation>
          <Center><x>{x:.9f}</x><y>{y:.9f}</y><z>{z:.9f}</z><Accurate>true</Accurate></Center>
          <Metadata><SRSId>0</SRSId><Center><x>9</x><y>48</y><z>400</z></Center></Metadata></Pose>
        <NearDepth>60</NearDepth><MedianDepth>100</MedianDepth></Photo>"""
    out.write(name, f"""<?xml version="1.0" encoding="utf-8"?>
<BlocksExchange version="3.2">
  <SpatialReferenceSystems><SRS><Id>0</Id><Name>input</Name><Definition>EPSG:4326</Definition></SRS>
    <SRS><Id>2</Id><Name>block</Name><Definition>{srs}</Definition></SRS></SpatialReferenceSystems>
  <Block><Name>fixture</Name><SRSId>2</SRSId><Photogroups>
    <Photogroup><Name>group 1</Name><ImageDimensions><Width>{WIDTH}</Width><Height>{HEIGHT}</Height></ImageDimensions>
      <CameraModelType>Perspective</CameraModelType><FocalLength>{FOCAL / WIDTH * 36:.15f}</FocalLength><SensorSize>36</SensorSize>
      <CameraOrientation>{orientation}</CameraOrientation>
      <PrincipalPoint><x>{WIDTH / 2 + OFFSET[0]}</x><y>{HEIGHT / 2 + OFFSET[1]}</y></PrincipalPoint>
      <Distortion><K1>{K1}</K1><K2>{K2}</K2><K3>{K3}</K3><P1>{P2}</P1><P2>{P1}</P2></Distortion>
      <AspectRatio>1</AspectRatio><Skew>0</Skew>{photos}
    </Photogroup></Photogroups></Block>
</BlocksExchange>
""")


def write_metashape(out, name, geocentric_chunk):
    """A chunk has a frame of its own: turned, scaled and moved against the world."""
    inner, scale = mul(turn("z", 33), turn("x", 12)), 7.25
    if geocentric_chunk:
        rotation, translation = mul(enu_axes(), transposed(inner)), geocentric([5, -7, 20])
        reference = ('PROJCS["WGS 84 / UTM zone 32N",GEOGCS["WGS 84",DATUM["World Geodetic System 1984",SPHEROID["WGS 84",6378137,298.257223563]],'
                     'PRIMEM["Greenwich",0],UNIT["degree",0.01745329251994328]],PROJECTION["Transverse_Mercator"],PARAMETER["latitude_of_origin",0],'
                     'PARAMETER["central_meridian",9],PARAMETER["scale_factor",0.9996],PARAMETER["false_easting",500000],PARAMETER["false_northing",0],'
                     'UNIT["metre",1],AUTHORITY["EPSG","32632"]]')
    else:
        rotation, translation = transposed(inner), on_map([5, -7, 20])
        reference = 'LOCAL_CS["Local Coordinates",LOCAL_DATUM["Local Datum",0],UNIT["metre",1]]'
    cameras = ""
    for i, (image, (angles, centre)) in enumerate(zip(NAMES, POSES)):
        m = mul(inner, mul(world_from_camera(angles), [[1, 0, 0], [0, -1, 0], [0, 0, -1]]))
        t = [v / scale for v in apply(inner, [c - o for c, o in zip(centre, (5, -7, 20))])]
        transform = " ".join(f"{v:.16e}" for row, x in zip(m, t) for v in row + [x]) + " 0 0 0 1"
        cameras += f'\n      <camera id="{i}" sensor_id="0" component_id="0" label="{image}"><transform>{transform}</transform></camera>'
    out.write(name, f"""<?xml version="1.0" encoding="UTF-8"?>
<document version="2.0.0">
  <chunk label="Chunk 1" enabled="true">
    <sensors next_id="2">
      <sensor id="0" label="camera, 6 um" type="frame"><resolution width="{WIDTH}" height="{HEIGHT}"/>
        <calibration type="frame" class="initial"><resolution width="{WIDTH}" height="{HEIGHT}"/><f>900</f></calibration>
        <calibration type="frame" class="adjusted"><resolution width="{WIDTH}" height="{HEIGHT}"/>
          <f>{FOCAL}</f><cx>{OFFSET[0]}</cx><cy>{OFFSET[1]}</cy>
          <k1>{K1}</k1><k2>{K2}</k2><k3>{K3}</k3><p1>{P2}</p1><p2>{P1}</p2></calibration></sensor>
      <sensor id="1" label="unused" type="fisheye"/>
    </sensors>
    <components next_id="1" active_id="0"><component id="0" label="Component 1"><transform>
      <rotation locked="true">{flat(rotation)}</rotation>
      <translation locked="true">{" ".join(f"{v:.9f}" for v in translation)}</translation><scale locked="true">{scale}</scale>
    </transform></component></components>
    <cameras next_id="5">{cameras}
      <camera id="4" sensor_id="1" label="not aligned.tif"/>
    </cameras>
    <reference>{reference}</reference>
  </chunk>
</document>
""")


def axis_angle(m):
    angle = math.acos(max(-1.0, min(1.0, (m[0][0] + m[1][1] + m[2][2] - 1) / 2)))
    axis = [m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1]]
    return [v / (2 * math.sin(angle)) * angle for v in axis]


def write_opensfm(out):
    side = max(WIDTH, HEIGHT)
    shots = {}
    for image, (angles, centre) in zip(NAMES, POSES):
        m = mul([[1, 0, 0], [0, -1, 0], [0, 0, -1]], transposed(world_from_camera(angles)))
        shots[image] = {"rotation": axis_angle(m), "translation": [-v for v in apply(m, centre)], "camera": "cam 1"}
    camera = {"projection_type": "brown", "width": WIDTH, "height": HEIGHT, "focal_x": FOCAL / side, "focal_y": FOCAL / side,
              "c_x": OFFSET[0] / side, "c_y": OFFSET[1] / side, "k1": K1, "k2": K2, "k3": K3, "p1": P1, "p2": P2}
    out.write("opensfm.json", json.dumps([{"cameras": {"cam 1": camera}, "shots": shots, "points": {"1": {"coordinates": [1, 2, 3]}},
              "reference_lla": {"latitude": LAT, "longitude": LON, "altitude": 0.0}}], ensure_ascii=False, indent=1) + "\n")


def write_pix4d(out):
    text = ("fileName imageWidth imageHeight \ncamera matrix K [3x3]\nradial distortion [3x1]\ntangential distortion [2x1]\n"
            "camera position t [3x1]\ncamera rotation R [3x3]\ncamera model m = K [R|-Rt] X\n\n")
    for image, (angles, centre) in zip(NAMES, POSES):
        m = mul([[1, 0, 0], [0, -1, 0], [0, 0, -1]], transposed(world_from_camera(angles)))
        text += f"{image} {WIDTH} {HEIGHT}\n{FOCAL} 0 {WIDTH / 2 + OFFSET[0]}\n0 {FOCAL} {HEIGHT / 2 + OFFSET[1]}\n0 0 1\n{K1} {K2} {K3}\n{P1} {P2}\n"
        text += " ".join(str(v) for v in centre) + "\n" + "".join(" ".join(f"{v:.17f}" for v in row) + "\n" for row in m)
    out.write("block_calibrated_camera_parameters.txt", text)
    out.write("block_offset.xyz", " ".join(f"{v:.3f}" for v in ORIGIN) + "\n")


def main():
    out = Writer(sys.argv[1])
    write_observations(out)
    write_tables(out)
    write_pat_b(out)
    write_inpho(out, False)
    write_inpho(out, True)
    for orientation in AXES:
        write_blocks_exchange(out, f"blocks_exchange_{orientation}.xml", orientation, "EPSG:25832", on_map)
    write_blocks_exchange(out, "blocks_exchange_angles.xml", "XRightYUp", "EPSG:25832", on_map, True)
    write_blocks_exchange(out, "blocks_exchange_enu.xml", "XRightYDown", f"ENU:{LAT},{LON}", lambda x: x)
    write_blocks_exchange(out, "blocks_exchange_geocentric.xml", "XRightYDown", "EPSG:4978", geocentric,
                          world_axes=enu_axes())
    write_metashape(out, "metashape_local.xml", False)
    write_metashape(out, "metashape_utm.xml", True)
    write_opensfm(out)
    write_pix4d(out)


main()
