// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>

#include "tests/io/shell.h"
#include "tests/io/temp_folder.h"

// What somebody meets in the first hour with the program: a full disk, options over a case, values that belong to another house.

namespace {

using shell::Outcome;

using shell::voussoir;

bool says(const Outcome& o, std::initializer_list<const char*> parts) {
  for (const char* p : parts) {
    if (o.text.find(p) != std::string::npos) continue;
    MESSAGE("missing '" << std::string(p) << "' in: " << o.text);
    return false;
  }
  return true;
}
bool is_silent_of(const Outcome& o, const char* part) {
  if (o.text.find(part) == std::string::npos) return true;
  MESSAGE("'" << std::string(part) << "' in: " << o.text);
  return false;
}

constexpr const char* kTwoBlocks = R"(title = "two blocks"
[gravity]
settle = false
[time]
duration = 0.01
[materials.stone]
density = 2000.0
young = 1e8
poisson = 0.2
[joints]
default = "dry"
[base]
z = 0.0
[[output.history]]
name = "low"
point = [0.1, 0.1, 0.1]
[[output.history]]
name = "high"
point = [0.1, 0.1, 0.3]
[[block]]
name = "a"
material = "stone"
box = [[0, 0, 0], [0.2, 0.2, 0.2]]
[[block]]
name = "b"
material = "stone"
box = [[0, 0, 0.2], [0.2, 0.2, 0.4]]
)";

constexpr const char* kRest = "t [s], a [m/s2]\n0, 0\n1, 0\n";

}  // namespace

TEST_CASE("a disk that is full before the first checkpoint: the message promises no way on that is none") {
  const TempFolder folder;
  const std::string data = VOUSSOIR_SOURCE_DIR "/tests/faults/data/";
  for (const char* name : {"wall.toml", "y.csv"}) std::filesystem::copy_file(data + name, folder.path(name));
  const std::string out = folder.path("out"), words = "run " + folder.path("wall.toml") + " --quiet -j 1 --duration 0.1 -o " + out;
  const Outcome fuller = voussoir(words, "ulimit -f 100; ");  // half kB: not even run.h5 fits
  CHECK(fuller.code == 3);
  CHECK(says(fuller, {"File too large", "before its first checkpoint", "run the case anew", "--overwrite"}));
  std::filesystem::remove_all(out);
  const Outcome full = voussoir(words, "ulimit -f 560; ");  // run.h5 fits, no checkpoint does
  CHECK(full.code == 3);
  CHECK(says(full, {"File too large", "before its first checkpoint", "run the case anew", "--overwrite"}));
  CHECK(is_silent_of(full, "resume"));
  CHECK(std::filesystem::exists(out + "/run.h5"));
  const Outcome resumed = voussoir("resume " + out);
  CHECK(resumed.code == 3);
  CHECK(says(resumed, {"holds no checkpoint", "run the case anew", "--overwrite"}));
  CHECK(voussoir(words + " --overwrite").code == 0);
}

TEST_CASE("an override that takes whole tables away says which") {
  const TempFolder folder;
  const std::string check = "check " + folder.write("case.toml", kTwoBlocks);
  const Outcome o = voussoir(check + " --set output.history=");
  CHECK(o.code == 0);
  CHECK(says(o, {"note: --set output.history= takes away", "(2: low, high)"}));
  CHECK(is_silent_of(voussoir(check + " --set gravity.settle="), "note:"));
  CHECK(voussoir(check + " --set output.histry=").code == 2);
}

TEST_CASE("a source of the motion replaces that of the case, by --set as by --motion, of either family of axes") {
  const TempFolder folder;
  folder.write("rest.csv", kRest);
  const std::string other = folder.write("other.csv", kRest);
  const auto run = [&](const std::string& motion, const std::string& words) {
    const std::string name = folder.write("case.toml", std::string(kTwoBlocks) + "[motion]\n" + motion + "\n");
    const Outcome o = voussoir("run " + name + " --quiet --overwrite -j 1 -o " + folder.path("out") + " " + words);
    if (o.code != 0) MESSAGE(o.text);
    return o.code;
  };
  for (const std::string motion : {"record = \"bam-like\"\ndirection = \"TLV\"", "x = \"rest.csv\"\nunit = \"g\"",
                                   "L = \"rest.csv\"\nV = \"rest.csv\"\ndirection = \"TLV\""}) {
    for (const std::string axis : {"x", "y", "L", "T"}) {
      CAPTURE(motion);
      CAPTURE(axis);
      CHECK(run(motion, "--motion " + axis + "=" + other) == 0);
      CHECK(run(motion, "--set motion." + axis + "=other.csv") == 0);
    }
    CHECK(run(motion, "--set motion.record=bam-like") == 0);
    CHECK(run(motion, "--record bam-like") == 0);
    CHECK(run(motion, "--set motion.x=other.csv --motion y=" + other) == 0);
    CHECK(run(motion, "--set motion.x=other.csv --set motion.L=other.csv") == 2);
    CHECK(run(motion, "--set motion.record=bam-like --motion y=" + other) == 2);
  }
}

namespace {

/// A small house, and a user's case that includes it.
constexpr const char* kSmallHouse = R"(title = "a small house"
[time]
duration = 0.002
[damping]
ratio = 0.02
frequency = 8.0
[materials.adobe]
density = 1800.0
young = 9.8e7
poisson = 0.25
[materials.wood]
density = 700.0
young = 6.3e8
poisson = 0.3
[joint_laws.weak]
tension = 4.6e3
cohesion = 2.9e3
friction = 32.0
compression = 4.9e5
thickness = 0.01
young = 9.8e7
poisson = 0.25
[joint_laws.wood]
tension = 1.1e7
cohesion = 9.0e6
friction = 0.0
compression = 4.5e7
[joints]
default = "weak"
[base]
z = 0.0
[[output.history]]
name = "left"
point = [0.1, 1.2, 1.7]
[house]
inner_size = [2.8, 2.0]
height = 2.0
brick = [0.4, 0.2, 0.2]
joint = "weak"
wood = { between_members = "weak" }
roof = { kind = "flat", between_beams = "weak", surcharge = 50.0 }
[[house.opening]]
wall = "front"
from = 1.0
width = 0.8
height = 1.6
lintel = { length = 1.2, height = 0.2 }
)";

}  // namespace

TEST_CASE("a house that cracks under its own weight: a warning with how many and where, and settling and shaking apart in all results") {
  const TempFolder folder;
  const std::string name = folder.write("case.toml", kSmallHouse), out = folder.path("out");
  const Outcome o = voussoir("run " + name + " --quiet -j 1 -o " + out);
  REQUIRE(o.code == 0);
  CHECK(says(o, {"warning: ", " contact points of joints broke under the building's own weight, while it settled (", " in tension",
                 "Where: ", " wall ", "between z = ", "first crack          while settling; afterwards none", "of them settling"}));
  // Shares of the parts add up to all of it, but for rounding.
  const std::string where = o.text.substr(o.text.find("Where: "), o.text.find("between z = ") - o.text.find("Where: "));
  int shares = 0, parts = 0;
  for (std::size_t at = where.find(" %"); at != std::string::npos; at = where.find(" %", at + 1), ++parts)
    shares += std::stoi(where.substr(where.rfind(' ', at - 1) + 1));
  CHECK(parts >= 2);
  CHECK(shell::run("grep -q '^frame_interval = 0.02 ' " + shell::quoted(out + "/case.toml")).code == 0);  // in place of "auto"
  CHECK(std::abs(shares - 100) <= parts);
  const Outcome s = voussoir("summary " + out);
  CHECK(says(s, {"first crack          while settling; afterwards never", "broken by settling   ", " s after it began; afterwards 0",
                 "points of settling"}));
  CHECK(is_silent_of(s, "from 0.000 s"));
  CHECK(says(voussoir("summary " + out + " --format json"),
             {"\"settling_cracks\": ", "\"shaking_cracks\": 0", "\"settling_first_crack_time\": -",
              "\"settling_tension\": ", "\"settling_damage_grade\": "}));
  CHECK(voussoir("report " + out).code == 0);
  CHECK(shell::run("grep -c settling_cracks " + shell::quoted(out + "/report.html")).code == 0);
  // Gone on with from a checkpoint after the settling, the numbers are the same, and the warning does not come again.
  const Outcome on = voussoir("resume " + out + " --until 0.003 --quiet -j 1");
  CHECK(on.code == 0);
  CHECK(says(on, {"while settling; afterwards"}));
  CHECK(is_silent_of(on, "own weight"));
  const std::string strong =
      "run " + name + " --quiet -j 1 -o " + folder.path("strong") + " --set joint_laws.weak.tension=1e7 --set joint_laws.weak.cohesion=1e7";
  CHECK(is_silent_of(voussoir(strong), "own weight"));
}

TEST_CASE("auto in a house whose beams lie loose: their weight is taken to hold them") {
  const TempFolder folder;
  const std::string path =
      folder.write("case.toml", std::string(kSmallHouse) +
                                    "[[house.floor]]\nspacing = 0.5\nelement = 0.4\nbearing = 0.2\n[[house.storey]]\nheight = 0.4\n");
  const Outcome automatic = voussoir("check " + path + " -j 1 --set damping.frequency=auto");
  CHECK(says(automatic, {"damping.frequency = \"auto\": ", "of the mass in y), with joints without a bond held as if bonded"}));
  const Outcome modes = voussoir("modes " + path + " --no-impulse --quiet --closed --count 1");
  CHECK(says(modes, {"stiffness, joints without a bond held as if bonded"}));
}

TEST_CASE("check tells of what nothing has, of motions that no record has, and of the frequency of a house with loose beams") {
  const TempFolder folder;
  const std::string more =
      "[materials.basalt]\ndensity = 2900.0\nyoung = 5e10\npoisson = 0.2\n"
      "[joint_laws.lime]\ntension = 5e4\ncohesion = 8e4\nfriction = 30.0\ncompression = 2e6\n";
  const std::string path = folder.write("case.toml", std::string(kSmallHouse) + more);
  const Outcome unused = voussoir("check " + path + " -j 1");
  CHECK(says(unused,
             {"warning: ", "case.toml:", "joint_laws.lime is the law of no joint", "materials.basalt is the material of no element"}));
  CHECK(says(unused, {"joint law ", "tension [Pa]", "when open"}));
  CHECK(is_silent_of(voussoir("check two-storeys -j 1"), "warning"));

  folder.write("g.csv", "t [s], a [g]\n0, 0\n0.01, 280\n0.02, 0\n");
  const Outcome strong = voussoir("check " + path + " -j 1 --set time.duration=1 --set motion.x=" + folder.path("g.csv"));
  CHECK(says(strong, {"warning: the motion along x is stronger than any record: peaks of 2746 m/s2", "motion.unit"}));
  const Outcome level =
      voussoir("check " + path + " -j 1 --set time.duration=1 --set motion.record=bam-like --set motion.scale=[1,0.01,1] " +
               "--set motion.intensity.measure=PGA --set motion.intensity.level=2 --set \"motion.intensity.components=geometric mean\"");
  const Outcome each = voussoir("check " + path + " -j 1 --set motion.record=bam-like --set motion.scale=[1,0.01,1] " +
                                "--set motion.intensity.measure=PGA --set motion.intensity.level=2");
  CHECK(says(each, {"warning: motion.intensity brings each horizontal component to the level, and as recorded one horizontal component is ",
                    " times as strong as the other; motion.intensity.components = \"larger\" keeps their ratio"}));
  CHECK(says(each, {"motion.intensity         PGA = 2 m/s2, of each horizontal component, by a factor of its own"}));
  CHECK(says(each, {"  scaling along x        PGA 7.811 -> 2 m/s2 (0.204 g), factor 0.2561\n"}));
  CHECK(says(each, {"  scaling along y        PGA 0.0623 -> 2 m/s2 (0.204 g), factor 32.1\n"}));
  CHECK(says(voussoir("check " + path + " -j 1 --record bam-like --direction TLV --scale 0.5 --duration 2"),
             {"motion along x", "bam-like T", "ground until the end     peaks ",
              " up to 2.000 s; along x, y, z the record's peak comes later, when the run has ended\n"}));
  CHECK(is_silent_of(voussoir("check " + path + " -j 1 --record bam-like --duration 21"), "ground until the end"));
  CHECK(says(
      voussoir("check " + path + " -j 1 --set motion.record=bam-like --set motion.intensity.measure=Sa --set motion.intensity.level=2 " +
               "--set motion.intensity.period=0.049"),
      {"warning: motion.intensity.period = 0.049 s is shorter than ten steps of the record (0.005 s)"}));
  CHECK(is_silent_of(voussoir("check " + path + " -j 1 --set motion.record=bam-like --set motion.intensity.measure=Sa " +
                              "--set motion.intensity.level=2 --set motion.intensity.period=0.05"),
                     "ten steps"));
  const std::string rods =
      "include = \"flat20n\"\n[[house.tie]]\nname = \"rods\"\nkind = \"along\"\nheights = [1.5]\narea = 2e-4\nplate = [0.2, 0.2]\n";
  CHECK(says(voussoir("check -j 1 " + folder.write("rods.toml", rods)),
             {"warning: ", "rods.toml:5: house.tie[0].heights", "along the front wall at 1.5 m runs through house.opening[0]"}));
  const Outcome pushover = voussoir("check " + path + " -j 1 --set analysis.kind=pushover --set motion.record=bam-like " +
                                    "--set motion.intensity.measure=PGA --set motion.intensity.level=2");
  CHECK(says(pushover, {"analysis                 pushover; [motion] is left out"}));
  CHECK(is_silent_of(pushover, "warning: motion"));
  CHECK(is_silent_of(pushover, "motion along"));
  CHECK(says(level, {"warning: motion.intensity is a geometric mean, and one horizontal component is ", "scale = [1, 0, 1]"}));
  CHECK(says(level, {"warning: motion.intensity: the whole record has PGA = 2 m/s2, but up to the end of the run, at 1 s, it is "}));
  CHECK(says(level, {" along x, ", " along y); motion.to cuts the record before it is measured"}));
  CHECK(says(strong, {"warning: the motion ends at 0.02 s: the ground is still until the run ends, at "}));

  const std::string loose = folder.write("loose.toml", std::string(kSmallHouse) +
                                                           "[[house.floor]]\nspacing = 0.5\nelement = 0.4\nbearing = 0.2\n"
                                                           "[[house.storey]]\nheight = 0.4\n");
  CHECK(says(voussoir("check " + loose + " -j 1 --set damping.frequency=300"),
             {"warning: damping.frequency = 300 Hz is more than 20 % off"}));
}

TEST_CASE("a damping frequency that is not the model's is told; auto takes that of the mode with the largest mass in y") {
  const TempFolder folder;
  const std::string check = "check " + folder.write("case.toml", kSmallHouse) + " -j 1 ";
  CHECK(is_silent_of(voussoir(check), "warning"));
  CHECK(is_silent_of(voussoir("check flat20n -j 1"), "warning"));
  CHECK(is_silent_of(voussoir("check vault40n -j 1"), "warning"));
  CHECK(says(voussoir(check + "--set damping.frequency=300"),
             {"warning: damping.frequency = 300 Hz is more than 20 % off the model's own: ", "of the mass in y)", "\"auto\""}));
  CHECK(says(voussoir(check + "--set damping.frequency=5.0"), {"warning: damping.frequency = 5 Hz"}));
  CHECK(is_silent_of(voussoir(check + "--set damping.frequency=300 --set damping.ratio=0 --set gravity.ramp=1"), "warning"));

  const std::string run = "run " + folder.path("case.toml") + " --quiet -j 1 --set gravity.settle=false -o " + folder.path("out");
  const Outcome automatic = voussoir(run + " --set damping.frequency=auto");
  CHECK(automatic.code == 0);
  CHECK(says(automatic, {"damping.frequency = \"auto\": ", "of the mass in y)"}));
  const Outcome written = shell::run("grep '^frequency' " + shell::quoted(folder.path("out/case.toml")));
  CHECK(is_silent_of(written, "auto\" "));
  const double frequency = std::strtod(written.text.substr(written.text.find('=') + 1).c_str(), nullptr);
  // Of the modes that the other command lists, the one with the largest share in y.
  double of_y = 0.0, largest = 0.0;
  std::istringstream modes(voussoir("modes " + folder.path("case.toml") + " --no-impulse --quiet").text);
  for (std::string line; std::getline(modes, line);) {
    double number = 0.0, hertz = 0.0, x = 0.0, y = 0.0, z = 0.0;
    std::istringstream row(line);
    if (row >> number >> hertz >> x >> y >> z && y > largest) of_y = hertz, largest = y;
  }
  CHECK(largest > 50.0);
  CHECK(frequency == doctest::Approx(of_y).epsilon(1e-3));
  // The same bits as with the number.
  const std::string number =
      written.text.substr(written.text.find('=') + 2, written.text.find(' ', written.text.find('=') + 2) - written.text.find('=') - 2);
  CHECK(voussoir("run " + folder.path("case.toml") + " --quiet -j 1 --set gravity.settle=false -o " + folder.path("same") +
                 " --set damping.frequency=" + number)
            .code == 0);
  CHECK(says(voussoir("compare " + folder.path("out") + " " + folder.path("same")), {"identical"}));

  CHECK(says(voussoir(check + "--set damping.frequency=own"), {"damping.frequency", "\"auto\" or a number"}));
  CHECK(says(voussoir(check + "--set damping.frequency=0"), {"damping.frequency", "> 0"}));
  const std::string blocks = "check " + folder.write("blocks.toml", kTwoBlocks) + " --set damping.ratio=0.02 --set damping.frequency=auto";
  CHECK(says(voussoir(blocks), {"damping.frequency = \"auto\": ", "with joints without a bond held as if bonded"}));
  const Outcome loose =  // both float
      voussoir(blocks + " --set base.z=-1 --set block[0].free=true --set block[1].free=true");
  CHECK(loose.code == 2);
  CHECK(says(loose, {"damping.frequency", "no mode moves a tenth of the mass along y"}));
}

TEST_CASE("followed points outside the model are refused, with how far the nearest element is") {
  const TempFolder folder;
  const std::string name = folder.write("case.toml", kSmallHouse);
  const Outcome far = voussoir("check " + name + " -j 1 --set 'output.history[0].point=[-1.5, 1.2, 1.7]'");
  CHECK(far.code == 2);
  CHECK(
      says(far, {"output.history[0].point", "m: \"left\" lies outside the model", "left wall", "is 1.5 m away", "allowed: in an element"}));
  CHECK(voussoir("run " + name + " --quiet -j 1 -o " + folder.path("out") + " --set 'output.history[0].point=[1.6, 1.2, 0.9]'").code == 2);
  CHECK_FALSE(std::filesystem::exists(folder.path("out")));
  CHECK(voussoir("check " + name + " -j 1 --set 'output.history[0].point=[3.3, 1.2, 1.7]'").code == 0);
}

TEST_CASE("what a house of another size has from the one it includes is told, and can be taken away") {
  const TempFolder folder;
  folder.write("house.toml", kSmallHouse);
  const auto check = [&](const std::string& text) {
    return voussoir("check -j 1 " + folder.write("mine.toml", "include = \"house.toml\"\n" + text));
  };
  const Outcome longer = check("[house]\ninner_size = [3.2, 2.0]\n");
  CHECK(longer.code == 0);
  CHECK(says(longer, {"warning: ", "warnings: 1", "mine.toml:3 gives house.inner_size", "still of the house that is included",
                      "house.opening (1)", "house.roof.surcharge = 50", "output.history (1)", "damping.frequency = 8", "opening = []"}));
  CHECK(is_silent_of(check("[house]\njoint = \"wood\"\n"), "still of the house"));
  const Outcome own = check(
      "[damping]\nfrequency = 8.0\n[output]\nhistory = []\n[house]\ninner_size = [3.2, 2.0]\nopening = []\nroof = { surcharge = 0.0 }\n");
  CHECK(own.code == 0);
  CHECK(is_silent_of(own, "still of the house"));
  CHECK(is_silent_of(own, "lintel"));
}

TEST_CASE("a rule between two materials that applies to no joint is told, with the reason") {
  const TempFolder folder;
  const std::string name = folder.write("case.toml", std::string(kSmallHouse) +
                                                         "[[joints.between]]\nmaterials = [\"adobe\", \"wood\"]\nlaw = \"wood\"\n"
                                                         "[[joints.between]]\nmaterials = [\"stone\", \"base\"]\nlaw = "
                                                         "\"wood\"\n[materials.stone]\ndensity = 2000.0\nyoung = 1e9\npoisson = 0.2\n");
  const Outcome o = voussoir("check -j 1 " + name);
  CHECK(o.code == 0);
  CHECK(says(o, {"warning: joints.between[0] (adobe, wood) applies to no joint: wherever these touch, the house's own keys",
                 "warning: joints.between[1] (stone, base) applies to no joint: no faces of these two touch"}));
  const Outcome used =
      voussoir("check -j 1 " + folder.write("blocks.toml", std::string(kTwoBlocks) +
                                                               "[[joints.between]]\nmaterials = [\"stone\", \"base\"]\nlaw = \"dry\"\n"));
  CHECK(used.code == 0);
  CHECK(is_silent_of(used, "applies to no joint"));
  // Without a house there are no keys of a house to blame.
  const Outcome blocks =
      voussoir("check -j 1 " + folder.write("twice.toml", std::string(kTwoBlocks) +
                                                              "[[joints.between]]\nmaterials = [\"stone\", \"base\"]\nlaw = \"dry\"\n"
                                                              "[[joints.between]]\nmaterials = [\"stone\", \"base\"]\nlaw = \"dry\"\n"));
  CHECK(says(blocks, {"joints.between[1] (stone, base) applies to no joint: wherever these touch, an earlier rule comes first"}));
  CHECK(says(blocks, {"motion                   none"}));
}

TEST_CASE("check says how long a run takes as a range, from steps timed on the machine") {
  const TempFolder folder;
  const std::string check = "check -j 1 " + folder.write("case.toml", kSmallHouse);
  const Outcome brief = voussoir(check), lasting = voussoir(check + " --set time.duration=2000");
  for (const Outcome* o : {&brief, &lasting}) CHECK(says(*o, {"estimate, 1 threads", "if nothing breaks, some ", "if it collapses"}));
  CHECK(is_silent_of(brief, "time.multirate"));  // nothing to gain in a second
  CHECK(says(lasting, {"time.multirate"}));
  // An analysis that goes from one state of rest to the next has no time, and takes no several rates.
  const Outcome push =
      voussoir("check -j 1 " + folder.write("push.toml", kSmallHouse) + " --set analysis.kind=pushover --set time.multirate=4");
  CHECK(says(push, {"estimate, 1 threads", "times that where much breaks"}));
  CHECK(push.text.find("if it collapses") == std::string::npos);
  CHECK(is_silent_of(push, "time.multirate"));
}
