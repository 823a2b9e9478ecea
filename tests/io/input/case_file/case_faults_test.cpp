// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <random>

#include "io/input/case_file/case_file.h"
#include "io/input/files/errors.h"

using namespace voussoir;
using io::read_case;

namespace {

/// The message with which a text is refused; "accepted" if it is not.
std::string refusal(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    read_case({"test.toml", text}, overrides);
  } catch (const io::CaseFileError& e) {
    return e.what();
  }
  return "accepted";
}

/// The same of a file, for faults of files.
std::string file_refusal(const std::string& path) {
  try {
    io::load_case(path);
  } catch (const io::FileError& e) {
    return e.what();
  } catch (const io::CaseFileError& e) {
    return e.what();
  }
  return "accepted";
}

std::string temporary(const std::string& name, const std::string& text) {
  const std::filesystem::path path = std::filesystem::temp_directory_path() / name;
  std::ofstream(path, std::ios::binary) << text;
  return path.string();
}

const std::string kBlock = "[[block]]\nname = \"a\"\nmaterial = \"m\"\n";

}  // namespace

TEST_CASE("faults: syntax names file, line, column and reason") {
  const std::string message = refusal("title = \"a\"\n[time]\nduration = = 3\n");
  CHECK(message.starts_with("test.toml:3:12: "));
  CHECK(message.size() > 25);
  CHECK(refusal("[time]\nduration = 1\nduration = 2\n").starts_with("test.toml:3:"));
  CHECK(refusal("title = \"open").starts_with("test.toml:1:"));
}

TEST_CASE("faults: what is not in UTF-8 is told with its line and byte") {
  CHECK(refusal("title = \"caf\xE9\"\n") == "test.toml:1:13: byte 0xE9 is no UTF-8; save the file in UTF-8");
  CHECK(refusal("title = \"a\"\n# caf\xE9\n") == "test.toml:2:6: byte 0xE9 is no UTF-8; save the file in UTF-8");
  CHECK(refusal(std::string("t\0i\0", 4)) == "test.toml:1:2: a NUL byte, as in UTF-16; save the file in UTF-8");
  CHECK(refusal("\xFF\xFEt") == "test.toml:1:1: the file is in UTF-16; save it in UTF-8");
}

TEST_CASE("faults: unknown keys come with the nearest one and the list") {
  CHECK(refusal("[house]\nhieght = 2.0\n")
            .starts_with("test.toml:2: house.hieght: unknown key; did you mean \"height\"? Keys of [house]: inner_size, height,"));
  CHECK(refusal("\n[timee]\nstep = 1")
            .starts_with("test.toml:2: timee: unknown key; did you mean \"time\"? Keys of the case file: title, source, gravity,"));
  CHECK(refusal(kBlock + "box = [[0,0,0],[1,1,1]]\nqqqqqqqq = 1")
            .starts_with("test.toml:5: block[0].qqqqqqqq: unknown key; Keys of [block[0]]: name, "));
  CHECK(refusal("[materials.m]\ndensty = 1.0\nyoung = 1\npoisson = 0\n").find("did you mean \"density\"") != std::string::npos);
  CHECK(refusal("[output]\n[[output.history]]\nname = \"a\"\npiont = [0,0,0]")
            .starts_with("test.toml:4: output.history[0].piont: unknown key"));
  CHECK(refusal("[house]\nroof = { kind = \"flat\", beams = 3 }")
            .starts_with("test.toml:2: house.roof.beams: unknown key; did you mean \"beam\"?"));
}

TEST_CASE("faults: wrong types say what was found and what is wanted") {
  CHECK(refusal("[time]\nduration = \"ten\"") ==
        "test.toml:2: time.duration = \"ten\": found a string in quotes, wanted a number (s, in [0, 1e+06])");
  CHECK(refusal("[time]\nstep = \"fast\"") ==
        "test.toml:2: time.step = \"fast\": found a string in quotes, wanted \"auto\" or a number (s, > 0)");
  CHECK(refusal("[gravity]\nsettle = 1") == "test.toml:2: gravity.settle = 1: found an integer, wanted true or false");
  CHECK(refusal("[gravity]\nacceleration = -9.8") ==
        "test.toml:2: gravity.acceleration = -9.8: found a number with a fraction, wanted an array [x, y, z] (m/s2)");
  CHECK(refusal("[gravity]\nacceleration = [0, 0]") ==
        "test.toml:2: gravity.acceleration = [0, 0] m/s2 has 2 values, wanted an array [x, y, z]");
  CHECK(refusal("[gravity]\nacceleration = [0,\n0,\n\"x\"]") ==
        "test.toml:4: gravity.acceleration[2] = \"x\": found a string in quotes, wanted a number (m/s2)");
  CHECK(refusal("title = 5") == "test.toml:1: title = 5: found an integer, wanted a string in quotes");
  CHECK(refusal("title = 2026-01-01").find("found a date or time") != std::string::npos);
  CHECK(refusal("[house]\ncopies = [2.0, 1]")
            .starts_with("test.toml:2: house.copies[0] = 2: found a number with a fraction, wanted an integer"));
  CHECK(refusal("time = 3") == "test.toml:1: time = 3: found an integer, wanted a table");
  CHECK(refusal("[block]\nname = \"a\"") == "test.toml:1: block: found a table, wanted an array of tables ([[block]])");
  CHECK(refusal("block = [1]") == "test.toml:1: block[0] = 1: found an integer, wanted a table");
  CHECK(refusal("[materials]\nadobe = 3") == "test.toml:2: materials.adobe = 3: found an integer, wanted a table");
  CHECK(refusal("[motion]\nrecord = \"r\"\nscale = \"big\"").find("wanted a number or an array [L, T, V]") != std::string::npos);
}

TEST_CASE("faults: ranges name the value and what is allowed") {
  const std::string material = "[materials.m]\ndensity = 1800.0\nyoung = 1e8\npoisson = 0.2\n";
  CHECK(refusal("[materials.m]\ndensity = -3\nyoung = 1e8\npoisson = 0.2\n") == "test.toml:2: materials.m.density = -3 kg/m3: must be > 0");
  CHECK(refusal(material, {"materials.m.poisson=0.5"}) == "--set materials.m.poisson=0.5: materials.m.poisson = 0.5: must be in [0, 0.5)");
  CHECK(refusal(material, {"materials.m.poisson=0.4999"}) == "accepted");
  CHECK(refusal(material, {"materials.m.poisson=-1e-9"}) != "accepted");
  CHECK(refusal(material, {"materials.m.young=0"}) != "accepted");
  CHECK(refusal("[contact]\nfriction = 90") == "test.toml:2: contact.friction = 90 degrees: must be in [0, 90)");
  CHECK(refusal("[contact]\nfriction = 0") == "accepted");
  CHECK(refusal("[contact]\ndashpots = \"free\"").starts_with("test.toml:2: contact.dashpots = \"free\""));
  CHECK(refusal("[contact]\ncompression = -1") == "test.toml:2: contact.compression = -1 Pa: must be >= 0");
  CHECK(refusal("[contact]\ncompression = 1e6\ncrushing_depth = 0").starts_with("test.toml:3: contact.crushing_depth = 0 m"));
  CHECK(refusal("[contact]\ncrushing_energy = 5").starts_with("test.toml:2: contact.crushing_energy = 5 J/m2 needs compression"));
  CHECK(refusal("[contact]\nresidual_compression = 5").starts_with("test.toml:2: contact.residual_compression = 5 Pa needs compression"));
  CHECK(refusal("[contact]\ncompression = 2e6\nresidual_compression = 1e5")
            .starts_with("test.toml:3: contact.residual_compression = 1e+05 Pa needs crushing_energy"));
  CHECK(refusal("[contact]\ncompression = 2e6\ncrushing_energy = 900\nresidual_compression = 2e6")
            .starts_with("test.toml:4: contact.residual_compression = 2e+06 Pa is no less than compression"));
  CHECK(refusal("[contact]\ncompression = 2e6\ncrushing_energy = 900\nresidual_compression = 2e5") == "accepted");
  CHECK(refusal("[[contact.between]]\nmaterials = [\"a\", \"base\"]\nfriction = 90") ==
        "test.toml:3: contact.between[0].friction = 90 degrees: must be in [0, 90)");
  CHECK(refusal("[contact]\nbetween = [ {friction = 30} ]").starts_with("test.toml:2: contact.between[0].materials is missing"));
  CHECK(
      refusal("[contact]\nbetween = [ {materials = [\"a\", \"a\"]} ]").starts_with("test.toml:2: contact.between[0].friction is missing"));
  CHECK(refusal("[time]\nduration = 0") == "accepted");
  CHECK(refusal("[time]\nduration = -1e-300") != "accepted");
  CHECK(refusal("[time]\nstep = 0") == "test.toml:2: time.step = 0 s: must be > 0");
  CHECK(refusal("[time]\nduration = nan") == "test.toml:2: time.duration = nan s: must be finite");
  CHECK(refusal("[time]\nduration = inf") == "test.toml:2: time.duration = inf s: must be finite");
  CHECK(refusal("[gravity]\nacceleration = [0, -inf, 0]") == "test.toml:2: gravity.acceleration[1] = -inf m/s2: must be finite");
  for (const char* key : {"history_interval", "frame_interval", "ledger_interval"}) {
    CHECK(refusal("[output]\n" + std::string(key) + " = 0.0") == "test.toml:2: output." + std::string(key) + " = 0 s: must be > 0");
  }
  CHECK(refusal("[output]\nframe_interval = \"auto\"") == "accepted");
  CHECK(refusal("[output]\nframe_interval = \"often\"") ==
        "test.toml:2: output.frame_interval = \"often\": found a string in quotes, wanted \"auto\" or a number (s, > 0)");
  CHECK(refusal("[segments]\nsize = 0") != "accepted");
  CHECK(refusal("[house]\ncopies = [0, 1]") == "test.toml:2: house.copies[0] = 0: must be in [1, 1000]");
  CHECK(refusal("[house]\ncopies = [4294967297, 1]") != "accepted");
  CHECK(refusal("[scatter]\nseed = 3000000000").find("must be an integer of 32 bits") != std::string::npos);
  CHECK(refusal("[house]\ncopies = [-9223372036854775808, 1]") != "accepted");
  CHECK(refusal("[house]\nroof = { voussoirs = 2 }") != "accepted");
  CHECK(refusal("[base]\ntilt = [0, 90]") != "accepted");
  CHECK(refusal("[house]\nmaterial = \"\"") == "test.toml:2: house.material = \"\": must not be empty");
}

TEST_CASE("faults: words out of a few") {
  CHECK(refusal("[house]\nbond = \"dutch\"") ==
        "test.toml:2: house.bond = \"dutch\": must be \"english\" | \"running\" | \"header\" | \"flemish\" | \"rubble\"");
  CHECK(refusal("[failure]\nshear = true") == "test.toml:2: failure.shear = true: must be \"on\" | \"off\"");
  CHECK(refusal("[segments]\nrule = \"edges\"") == "test.toml:2: segments.rule = \"edges\": must be \"centres\" | \"rim\" | \"corners\"");
  CHECK(refusal("[house]\nturn = 45") == "test.toml:2: house.turn = 45 degrees: must be 0 | 90 | 180 | 270");
  CHECK(refusal("[house]\nturn = 90.0") == "accepted");
  CHECK(refusal("[house]\nturn = \"90\"") != "accepted");
  CHECK(refusal("[motion]\nrecord = \"r\"\ndirection = \"LLV\"") != "accepted");
  CHECK(refusal("[motion]\nrecord = \"r\"\ndirection = \"VTL\"") == "accepted");
  CHECK(refusal("[motion]\nrecord = \"r\"\nunit = \"gal\"").starts_with("test.toml:3: motion.unit = \"gal\": must be \"g\" | "));
}

TEST_CASE("faults: missing keys name their table's line") {
  CHECK(refusal("\n[materials.m]\ndensity = 1\nyoung = 1\n") ==
        "test.toml:2: materials.m.poisson is missing; wanted a number, in [0, 0.5): Poisson's ratio");
  for (const char* key : {"tension", "cohesion", "friction", "compression"}) {
    std::string text = "[joint_laws.n]\n";
    for (const char* other : {"tension", "cohesion", "friction", "compression"}) {
      if (std::string(other) != key) text += std::string(other) + " = 1.0\n";
    }
    CHECK(refusal(text).starts_with("test.toml:1: joint_laws.n." + std::string(key) + " is missing; "));
  }
  CHECK(refusal("[[block]]\nname = \"a\"\nbox = [[0,0,0],[1,1,1]]").starts_with("test.toml:1: block[0].material is missing"));
  CHECK(refusal("[[block]]\nmaterial = \"a\"\nbox = [[0,0,0],[1,1,1]]").starts_with("test.toml:1: block[0].name is missing"));
  CHECK(refusal("[[load]]\nforce = [1,0,0]").starts_with("test.toml:1: load[0].block is missing: name a block, or give `at` or `path`"));
  CHECK(refusal("[[load]]\nat = [1,0,0]").starts_with("test.toml:1: load[0].force is missing"));
  CHECK(refusal("[[load]]\nat = [1,0,0]\nforce = [1,0,0]\npath = \"a.csv\"").find("load[0].path") != std::string::npos);
  CHECK(refusal("[joints]\nbetween = [ {law = \"dry\"} ]").starts_with("test.toml:2: joints.between[0].materials is missing"));
  CHECK(refusal("[joints]\nbetween = [ {law = \"dry\", materials = [\"a\"]} ]").find("has 1 values, wanted an array of 2") !=
        std::string::npos);
  CHECK(
      refusal("[[house.opening]]\nwall = \"front\"\nfrom = 1\nheight = 1\n").starts_with("test.toml:1: house.opening[0].width is missing"));
}

TEST_CASE("faults: rules of damping and mortar") {
  CHECK(refusal("[damping]\nratio = 0.02\nfrequency = 6\nalpha = 1.5")
            .starts_with("test.toml:4: damping.alpha = 1.5 1/s does not go with damping.ratio"));
  CHECK(refusal("[damping]\nratio = 0.02").starts_with("test.toml:2: damping.ratio = 0.02 needs damping.frequency"));
  CHECK(refusal("[damping]\nfrequency = 6").starts_with("test.toml:2: damping.frequency = 6 Hz needs damping.ratio"));
  CHECK(refusal("[damping]\nfrequency = 6\nratio = 0") == "accepted");
  CHECK(refusal("[damping]\nfrequency = \"auto\"\nratio = 0.02") == "accepted");
  CHECK(refusal("[damping]\nfrequency = \"auto\"").starts_with("test.toml:2: damping.frequency = \"auto\" needs damping.ratio"));
  CHECK(refusal("[damping]\nratio = 0.02\nfrequency = \"first\"").find("\"auto\" or a number") != std::string::npos);
  CHECK(refusal("[house]\nwood = { timber_on_timber = \"\" }").starts_with("test.toml:2: house.wood.timber_on_timber"));
  CHECK(refusal("[house.reinforcement]\nring_beam_place = \"outside\"").find("must be \"inside\" | \"middle\"") != std::string::npos);
  CHECK(refusal("[damping]\nfrequency = 6\nratio = 2").starts_with("test.toml:3: damping.ratio = 2: must be"));
  CHECK(refusal("[damping]\nalpha = 1.5") == "accepted");
  CHECK(refusal("[damping]\nalpha = 1.5\nframe = \"absolute\"").starts_with("test.toml:3: damping.frame = \"absolute\""));
  const std::string law = "[joint_laws.n]\ntension = 1\ncohesion = 1\nfriction = 30\ncompression = 1\n";
  CHECK(refusal(law) == "accepted");
  CHECK(refusal(law + "thickness = 0.01\npoisson = 0.2").starts_with("test.toml:1: joint_laws.n.young is missing"));
  CHECK(refusal(law + "thickness = 0.01\nyoung = 1").starts_with("test.toml:1: joint_laws.n.poisson is missing"));
  CHECK(refusal(law + "thickness = 0.01\nyoung = 0\npoisson = 0").starts_with("test.toml:7: joint_laws.n.young = 0 Pa"));
  CHECK(refusal(law + "thickness = 0.01\nyoung = 1\npoisson = 0") == "accepted");
  const auto softening = [&](const std::string& keys) { return refusal(law + keys); };
  CHECK(softening("fracture_energy_tension = -1").starts_with("test.toml:6: joint_laws.n.fracture_energy_tension = -1"));
  CHECK(softening("fracture_energy_shear = -1").starts_with("test.toml:6: joint_laws.n.fracture_energy_shear = -1"));
  CHECK(softening("fracture_energy_shear = 1\nsoftening = \"steep\"").starts_with("test.toml:7: joint_laws.n.softening = \"steep\""));
  CHECK(softening("softening = \"linear\"").find("needs fracture_energy_tension or fracture_energy_shear") != std::string::npos);
  CHECK(softening("softening = \"exponential\"") == "accepted");  // as a resolved case says of a brittle law
  CHECK(softening("residual_friction = 90").starts_with("test.toml:6: joint_laws.n.residual_friction = 90"));
  CHECK(softening("dilatancy = 10").find("needs fracture_energy_shear") != std::string::npos);
  CHECK(softening("fracture_energy_shear = 1\ndilatancy = 31").find("is more than friction = 30") != std::string::npos);
  const std::string weak = "[joint_laws.n]\ntension = 0\ncohesion = 0\nfriction = 30\ncompression = 1\n";
  CHECK(refusal(weak + "fracture_energy_tension = 1").find("does not go with tension = 0") != std::string::npos);
  CHECK(refusal(weak + "fracture_energy_shear = 1").find("does not go with cohesion = 0") != std::string::npos);
  CHECK(refusal(law + "normal_stiffness = 1e9\nshear_stiffness = 4e8\n") == "accepted");
  CHECK(refusal(law + "normal_stiffness = 1e9").starts_with("test.toml:1: joint_laws.n.shear_stiffness is missing"));
  CHECK(refusal(law + "shear_stiffness = 1e9").starts_with("test.toml:1: joint_laws.n.normal_stiffness is missing"));
  CHECK(refusal(law + "normal_stiffness = 0\nshear_stiffness = 1")
            .starts_with("test.toml:6: joint_laws.n.normal_stiffness = 0 Pa/m: must be"));
  CHECK(refusal(law + "normal_stiffness = 1\nshear_stiffness = inf").starts_with("test.toml:7: joint_laws.n.shear_stiffness"));
  CHECK(refusal(law + "thickness = 0.01\nyoung = 1\npoisson = 0\nnormal_stiffness = 1\nshear_stiffness = 1")
            .starts_with("test.toml:6: joint_laws.n.thickness = 0.01 m does not go with normal_stiffness"));
  const std::string own = "normal_stiffness = 1e9\nshear_stiffness = 4e8\n";
  CHECK(refusal(weak + own + "maximum_closure = 1e-4") == "accepted");
  CHECK(refusal(weak + own + "maximum_closure = 0").starts_with("test.toml:8: joint_laws.n.maximum_closure = 0 m: must be"));
  CHECK(refusal(weak + "maximum_closure = 1e-4").find("needs normal_stiffness") != std::string::npos);
  CHECK(refusal(law + own + "maximum_closure = 1e-4").find("allowed with tension = 0 and cohesion = 0 alone") != std::string::npos);
  CHECK(refusal("[joint_laws.dry]\ntension = 1\ncohesion = 1\nfriction = 30\ncompression = 1\n").find("reserved") != std::string::npos);
  CHECK(refusal("[materials.base]\ndensity = 1\nyoung = 1\npoisson = 0\n").starts_with("test.toml:1: materials.base is a reserved name"));
}

TEST_CASE("faults: rules of stones") {
  const std::string stones = "[[stones]]\nfile = \"a.obj\"\n", good = stones + "unit = \"m\"\n";
  CHECK(refusal(stones).starts_with("test.toml:1: stones[0].unit is missing"));
  CHECK(refusal("[[stones]]\nunit = \"m\"").starts_with("test.toml:1: stones[0].file is missing"));
  CHECK(refusal(stones + "unit = \"yd\"").find("test.toml:3: stones[0].unit = \"yd\": must be \"m\" | \"cm\" | \"mm\" | \"in\" | \"ft\"") ==
        0);
  CHECK(refusal(good + "snap = 0.2").starts_with("test.toml:4: stones[0].snap = 0.2 m: "));
  CHECK(refusal(good + "snap = -1.0").starts_with("test.toml:4: stones[0].snap = -1 m: "));
  CHECK(refusal(good + "gap = 0.5").starts_with("test.toml:4: stones[0].gap = 0.5 m: "));
  CHECK(refusal(good + "gap = 0.002").find("must be above twice snap") != std::string::npos);
  CHECK(refusal(good + "warped = \"mend\"").starts_with("test.toml:4: stones[0].warped = \"mend\": must be \"refuse\" | \"triangles\""));
  CHECK(refusal(good + "fit = \"plane\"").starts_with("test.toml:4: stones[0].fit = \"plane\": must be \"snap\" | \"planes\""));
  CHECK(refusal(good + "fit = \"planes\"\nfit_limit = 0.0").starts_with("test.toml:5: stones[0].fit_limit = 0"));
  CHECK(refusal(good + "name = \"a/b\"").find("cannot hold '/'") != std::string::npos);
  CHECK(refusal(good + "supports = \"roof\"").starts_with("test.toml:4: stones[0].supports = \"roof\": "));
  CHECK(refusal(good + "supports = [1, 2]").starts_with("test.toml:4: stones[0].supports[0] = 1: "));
  CHECK(refusal(good + "turn = \"left\"").starts_with("test.toml:4: stones[0].turn = \"left\": "));
  CHECK(refusal(good + "turn = { axis = [0, 0, 0] }").find("stones[0].turn.axis") != std::string::npos);
  CHECK(refusal(good + "sanp = 0.1").find("stones[0].sanp: unknown key") != std::string::npos);
}

TEST_CASE("faults: rules of blocks and loads") {
  CHECK(refusal(kBlock + "vertices = [[0,0,0],[1,0,0],[0,1,0],[0,0,1]]").find("has 4 points, wanted 8, or faces beside them") !=
        std::string::npos);
  CHECK(refusal(kBlock + "faces = [[0,1,2]]").find("block[0] has no shape") != std::string::npos);
  CHECK(refusal(kBlock + "box = [[0,0,0],[1,1,1]]\nfaces = [[0,1,2]]").find("needs vertices") != std::string::npos);
  CHECK(refusal(kBlock) == "test.toml:1: block[0] has no shape; give box, or vertices, or polygon and extrude");
  CHECK(refusal(kBlock + "box = [[0,0,0],[1,1,1]]\npolygon = [[0,0],[1,0],[0,1]]\nextrude = [0,1]")
            .starts_with("test.toml:5: block[0].polygon = "));
  CHECK(refusal(kBlock + "polygon = [[0,0],[1,0],[0,1]]").find("needs extrude") != std::string::npos);
  CHECK(refusal(kBlock + "extrude = [0, 1]").find("needs polygon") != std::string::npos);
  CHECK(refusal(kBlock + "polygon = [[0,0],[1,0]]\nextrude = [0, 1]").find("has 2 points, wanted 3 or more") != std::string::npos);
  CHECK(refusal(kBlock + "polygon = [[0,0],[1,0],[0,1]]\nextrude = [1, 1]") ==
        "test.toml:5: block[0].extrude = [1, 1] m: must be [x0, x1] with x0 < x1");
  CHECK(refusal(kBlock + "polygon = [[0,0],[1,0],[0,1]]\nextrude = [0, 1]") == "accepted");
  CHECK(refusal(kBlock + "box = [[0,0,0],[1,0,1]]").find("has no volume") != std::string::npos);
  CHECK(refusal(kBlock + "box = [[0,0,0],[1,1,1]]\n[block.motion]\nvelocity = [1,0,0]") ==
        "test.toml:5: block[0].motion needs a fixed block (fixed = true)");
  CHECK(refusal(kBlock + "box = [[0,0,0],[1,1,1]]\nfixed = true\nmotion = {}").find("block[0].motion says nothing") != std::string::npos);
  CHECK(refusal(kBlock + "box = [[0,0,0],[1,1,1]]\nfixed = true\nmotion = { velocity = [1,0,0], file = \"f\" }") ==
        "test.toml:6: block[0].motion.file = \"f\" does not go with velocity; give one of them");
  const std::string moved = kBlock + "box = [[0,0,0],[1,1,1]]\nfixed = true\nmotion = ", rest = "\n[analysis]\nkind = \"rest\"";
  CHECK(refusal(moved + "{ file = \"f\", turn = [0,0,1] }").find("motion.turn = [0, 0, 1] degrees does not go with file") !=
        std::string::npos);
  CHECK(refusal(moved + "{ velocity = [1,0,0], about = [0,0,1] }").find("about = [0, 0, 1] m needs turn") != std::string::npos);
  CHECK(refusal(moved + "{ to = [0,0,1] }").find("needs analysis.kind = \"settlement\" or \"rest\"") != std::string::npos);
  CHECK(refusal(moved + "{ to = [0,0,1] }" + rest) == "accepted");
  CHECK(refusal(moved + "{ velocity = [0,0,1] }" + rest).find("has no end; with analysis.kind = \"rest\" give to") != std::string::npos);
  CHECK(refusal(moved + "{ to = [0,0,1] }" + rest + "\npace = 3.0").find("leave out solver, pace and damping") != std::string::npos);
  CHECK(refusal(kBlock + "box = [[0,0,0],[1,1,1]]" + rest) == "accepted");
  CHECK(refusal(kBlock + "box = [[0,0,0],[1,1,1]]\nfixed = true\nvelocity = [1,0,0]").find("does not go with fixed") != std::string::npos);
  CHECK(refusal(kBlock + "box = [[0,0,0],[1,1,1]]\nrotate = { axis = [0,0,0] }").find("has no direction") != std::string::npos);
  CHECK(refusal("[[load]]\nblock = \"a\"\nramp = [1, 0]").starts_with("test.toml:3: load[0].ramp = [1, 0] s: must be"));
}

TEST_CASE("faults: rules of motion and histories") {
  CHECK(refusal("[motion]\nrecord = \"r\"\nx = \"f\"").starts_with("test.toml:3: motion.x = \"f\" does not go with motion.record"));
  CHECK(refusal("[motion]\nrecord = \"r\"\nT = \"f\"").starts_with("test.toml:3: motion.T = \"f\" does not go with motion.record"));
  CHECK(refusal("[motion]\nx = \"f\"\nT = \"f\"").starts_with("test.toml:3: motion.T = \"f\" does not go with motion.x"));
  CHECK(refusal("[motion]\nscale = 2") == "test.toml:1: motion names no motion; give record, or files for x, y, z, or for L, T, V");
  CHECK(refusal("[motion]\nx = \"f\"\ndirection = \"TLV\"").starts_with("test.toml:3: motion.direction = \"TLV\" says where L, T, V go"));
  CHECK(refusal("[motion]\nx = \"f\"\ndirection = \"LTV\"") == "accepted");
  const std::string history = "[[output.history]]\npoint = [0,0,0]\nname = ";
  CHECK(refusal(history + "\"time\"").starts_with("test.toml:3: output.history[0].name = \"time\" cannot name"));
  CHECK(refusal(history + "\"top\\tleft\"").find("control characters") != std::string::npos);
  CHECK(refusal(history + "\"a/b\"").find("cannot name") != std::string::npos);
  CHECK(refusal(history + "\"a\"\n" + history + "\"a\"") ==
        "test.toml:6: output.history[1].name = \"a\" is the name of another history, too");
}

TEST_CASE("faults of cuts: names, planes without a direction, boxes without room") {
  const std::string cut = "[[output.cut]]\npoint = [0,0,1]\nname = ";
  CHECK(refusal("[[output.cut]]\nname = \"a\"").find("output.cut[0].point") != std::string::npos);
  CHECK(refusal(cut + "\"a/b\"").starts_with("test.toml:3: output.cut[0].name = \"a/b\" cannot name a group"));
  CHECK(refusal(cut + "\"a\"\nnormal = [0,0,0]").find("output.cut[0].normal") != std::string::npos);
  CHECK(refusal(cut + "\"a\"\nbox = [[0,0,0], [1,0,1]]").find("has no room in it") != std::string::npos);
  CHECK(refusal(cut + "\"a\"\nbox = [[0,0,0]]").find("output.cut[0].box") != std::string::npos);
  CHECK(refusal(cut + "\"a\"\n" + cut + "\"a\"") == "test.toml:6: output.cut[1].name = \"a\" is the name of another cut, too");
}

TEST_CASE("faults: the first in the file is reported, then those of overrides") {
  CHECK(refusal("[time]\nduration = -1\n[contact]\nfriction = 99\n").starts_with("test.toml:2: "));
  CHECK(refusal("[contact]\nfriction = 99\n[time]\nduration = -1\n").starts_with("test.toml:2: contact.friction"));
  CHECK(refusal("[contact]\nfriction = 99\n", {"time.duration=-1"}).starts_with("test.toml:2: contact.friction"));
  // The text order, even if a table is closed and opened again.
  CHECK(refusal("[[block]]\nname = \"a\"\nmaterial = \"m\"\nbox = [[0,0,0],[1,1,1]]\n[time]\nduration = -1\n[block.motion]\nvelocity = 3\n")
            .starts_with("test.toml:6: time.duration"));
}

TEST_CASE("later faults get file, line and value") {
  const io::LoadedCase loaded =
      read_case({"house.toml", "[house]\n\n[[house.opening]]\nwall = \"front\"\nfrom = 1\nwidth = 7.0\nheight = 2\n"}, {"house.height=3"});
  const auto describe = [&](const char* key, const char* problem) { return loaded.describe({key, problem}); };
  CHECK(describe("house.opening[0].width", "7 m is wider than the wall (5.4 m)") ==
        "house.toml:6: house.opening[0].width = 7 m is wider than the wall (5.4 m)");
  CHECK(describe("house.opening[0].width", "is wider than the wall (5.4 m)") ==
        "house.toml:6: house.opening[0].width = 7 m is wider than the wall (5.4 m)");
  CHECK(describe("house.opening[0].width", "must be less") == "house.toml:6: house.opening[0].width = 7 m: must be less");
  CHECK(describe("house.opening[0].wall", "\"front\" is no wall") == "house.toml:4: house.opening[0].wall = \"front\" is no wall");
  CHECK(describe("house.opening[0].lintel.length", "is missing") == "house.toml:3: house.opening[0].lintel.length is missing");
  CHECK(describe("house.opening[3].width", "too wide") == "house.toml:3: house.opening[3].width: too wide");
  CHECK(describe("house.bond", "does not fit") == "house.toml:1: house.bond does not fit");
  CHECK(describe("house.height", "too low") == "--set house.height=3: house.height = 3 m: too low");
  CHECK(describe("block[0]", "has no shape") == "house.toml: block[0] has no shape");
  CHECK(describe("", "nothing to do") == "house.toml: nothing to do");
}

TEST_CASE("hostile files are refused with their name") {
  CHECK(file_refusal("/nowhere/at/all.toml") == "/nowhere/at/all.toml: no such file");
  CHECK(file_refusal("/tmp/") == "/tmp/: is a folder, wanted a case file (.toml)");
  CHECK(file_refusal("/dev/zero") == "/dev/zero: is not a regular file");
  const std::string large = temporary("voussoir_large_case.toml", std::string((16U << 20U) + 1U, '#'));
  CHECK(file_refusal(large) == large + ": has 16777217 bytes; a case file may have 16 MB");
  std::filesystem::remove(large);
  CHECK(refusal(std::string("title = \"a\"\nsource = \"a\0b\"", 25)) == "test.toml:2:12: a NUL byte");
  CHECK(refusal("title = \"\xff\xfe\"").starts_with("test.toml:1:"));
}

TEST_CASE("hostile nesting neither overflows the stack nor passes") {
  std::string keys = "a";
  for (int i = 0; i < 1000000; ++i) keys += ".a";
  CHECK(refusal(keys + " = 1") == "test.toml:1:130: more than 64 dots in one key");
  CHECK(refusal("[" + keys + "]").find("more than 64 dots") != std::string::npos);
  CHECK(refusal("title = [" + std::string(1000000, '[')) != "accepted");
  std::string tables = "title = ";
  for (int i = 0; i < 100000; ++i) tables += "{a=";
  CHECK(refusal(tables) != "accepted");
  CHECK(refusal("title = \"" + keys + "\"") == "accepted");  // dots in a string are no key
  CHECK(refusal("# " + keys) == "accepted");
  CHECK(refusal(std::string(100000, 'k') + " = 1").size() < 500);
  CHECK(refusal("[time]\nduration = \"" + std::string(100000, 'v') + "\"").size() < 300);
}

TEST_CASE("random garbage never gets through as anything but a refusal or a case") {
  std::mt19937 random(2026);
  const std::string every_key = [] {
    std::ifstream in(VOUSSOIR_SOURCE_DIR "/tests/io/input/case_file/data/every_key.toml");
    return std::string(std::istreambuf_iterator<char>(in), {});
  }();
  REQUIRE(every_key.size() > 1000);
  int refused = 0;
  for (int i = 0; i < 3000; ++i) {
    std::string text = every_key;
    const int changes = 1 + static_cast<int>(random() % 4);
    for (int k = 0; k < changes; ++k) {
      const std::size_t at = random() % text.size();
      if (random() % 3 == 0) {
        text.erase(at, random() % 40);
      } else if (random() % 2 == 0) {
        text[at] = static_cast<char>(random());
      } else {
        text.insert(at, text.substr(random() % text.size(), random() % 60));
      }
    }
    const std::string message = refusal(text);
    if (message == "accepted") continue;
    ++refused;
    REQUIRE(message.starts_with("test.toml:"));
  }
  CHECK(refused > 1000);
  CHECK(refused < 3000);
}

TEST_CASE("faults: many keys take time in proportion, too many materials are refused before memory is taken for their pairs") {
  std::string keys, materials;
  for (int i = 0; i < 300000; ++i) keys += "k" + std::to_string(i) + " = 1\n";
  CHECK(refusal(keys).starts_with("test.toml:1: k0: unknown key"));
  for (int i = 0; i < 2001; ++i) materials += "[materials.m" + std::to_string(i) + "]\ndensity = 2000\nyoung = 1e9\npoisson = 0.2\n";
  CHECK(refusal(materials).find("materials has 2001 materials; allowed: at most 2000") != std::string::npos);
}
