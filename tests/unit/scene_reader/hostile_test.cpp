// Hostile and broken scenes end in an InputError that names a place, in seconds and within a gigabyte.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <functional>
#include <limits>
#include <random>
#include <regex>
#include <stdexcept>

#include "read.h"

namespace rays {
namespace {

std::string repeated(const std::string& part, int times) {
    std::string text;
    for (int i = 0; i < times; ++i) text += part;
    return text;
}

std::string grown(int levels, const std::string& first, const std::function<std::string(int)>& next) {
    std::string text = first;
    for (int i = 0; i < levels; ++i) text += next(i);
    return text;
}

struct Hostile {
    const char* name;
    std::string text;
    double patience = 1;  ///< times the seconds that a scene may take
};

std::vector<Hostile> hostile_scenes() {
    const std::string counting = "#declare I = 0; #while (I >= 0) #declare I = I + 1; ";
    const auto n = [](int i) { return std::to_string(i); };
    return {
        {"nested unions", repeated("union { ", 100'000)},
        {"nested parentheses", "#declare A = " + repeated("(", 100'000) + "1"},
        {"nested vectors", "#declare A = " + repeated("<", 100'000)},
        {"many signs", "#declare A = " + repeated("-", 100'000) + "1;"},
        {"nested arrays", "#declare A = array[1] " + repeated("{", 100'000)},
        {"nested ifs", repeated("#if (1) ", 100'000)},
        {"nested whiles", repeated("#while (I) ", 100'000)},
        {"nested transforms", "sphere { 0, 1 " + repeated("transform { ", 100'000)},
        {"nested macro arguments", "#macro F(A) (A) #end #declare B = " + repeated("F(", 100'000)},
        {"empty endless loop", "#while (1) #end"},
        {"endless loop that makes objects", "#while (1) sphere { 0, 1 } #end"},
        {"endless counting", counting + "#end"},
        {"endless strings", "#declare S = \"ab\"; " + counting + "#declare S = concat(S, S); #end"},
        {"endless kept strings",
         "#declare A = array[1000000]; " + counting + "#declare A[I] = \"" + std::string(10'000, 'x') + "\"; #end"},
        {"endless materials", counting + "sphere { I, 1 pigment { checker } interior { ior 1 } } #end"},
        {"endless lights", counting + "light_source { I, 1 } #end"},
        {"endless streams", counting + "#declare R = seed(I); #end"},
        {"endless skipping", counting + "#if (0) " + std::string(500'000, 'x') + " #end #end"},
        {"endless clips",
         "#declare S = sphere { 0, 1 } " + counting + "#declare S = object { S clipped_by { box { 0, 1 } } } #end"},
        {"endless media", "#declare M = media { density { spherical } } " + counting +
                              "#declare M = media { M density { spherical } } #end"},
        {"endless comments", counting + "/*" + std::string(500'000, 'x') + "*/ #end"},
        {"comments behind an array", "#declare A = array[2] { 1, 2 } #for (I, 0, 1e9) #declare B = A /*" +
                                         std::string(500'000, 'x') + "*/ [1]; #end"},
        {"endless questions for files", counting + "#declare F = file_exists(\"nothing.inc\"); #end"},
        {"endless digits",
         counting + "#declare S = vstr(5, <1e300, 1e300, 1e300, 1e300, 1e300>, \"a\", 200, 100); #end"},
        // Ten million spheres are a large scene, which must be read; one more ends this one.
        {"endless spheres", counting + "sphere { I, 1 } #end", 3},
        {"endless spheres with idle loops",
         counting + "#declare J = 0; #while (J < 20) #declare J = J + 1; #end sphere { I, 1 } #end"},
        {"endless faces", "mesh { " + counting + "triangle { 0, I*x, y } #end }"},
        {"for to the stars", "#for (I, 0, 1e300) #end"},
        {"for that is set back", "#for (I, 0, 2) #declare I = 0; #end"},
        {"large arrays", grown(10, "", [&](int i) { return "#declare A" + n(i) + " = array[5000000]; "; })},
        {"copied arrays",
         "#declare A = array[1000000]; #declare B = array[100]; #for (I, 0, 99) #declare B[I] = A; #end"},
        {"endless recursion", "#macro F() F() #end F()"},
        {"recursion in arguments", "#macro F(A) F(F(A)) #end F(1)"},
        {"recursion that forks", "#macro F(N) #if (N > 0) F(N - 1) F(N - 1) #end #end F(60)"},
        {"functions that double", grown(60, "#declare F0 = function(x) { x }; ",
                                        [&](int i) {
                                            return "#declare F" + n(i + 1) + " = function(x) { F" + n(i) + "(x) + F" +
                                                   n(i) + "(x) }; ";
                                        }) +
                                      "#declare A = F60(1);"},
        {"unions that double", grown(60, "#declare U0 = union { sphere { 0, 1 } }; ",
                                     [&](int i) {
                                         return "#declare U" + n(i + 1) + " = union { object { U" + n(i) +
                                                " } object { U" + n(i) + " } }; ";
                                     }) +
                                   "object { U60 }"},
        {"deep unions",
         grown(1000, "#declare U0 = union { sphere { 0, 1 } }; ",
               [&](int i) { return "#declare U" + n(i + 1) + " = union { object { U" + n(i) + " } }; "; }) +
             "object { U1000 }"},
        {"macros that double in a loop", grown(12, "#macro M0(X) (X + 1) #end ",
                                               [&](int i) {
                                                   return "#macro M" + n(i + 1) + "(X) (M" + n(i) + "(X) + M" + n(i) +
                                                          "(X + " + n(i) + ")) #end ";
                                               }) +
                                             counting + "#declare A = M11(I); #declare A = M11(I) + asc(\"a\"); #end"},
        {"rotations without end",
         "#declare V = <1, 2, 3>; " + counting + "#declare A = V" + repeated(" + vrotate(V, V)", 60) + "; #end"},
        {"numbers that overflow", "#declare A = 1; " + repeated("#declare A = A + A; ", 2000)},
        {"transforms that overflow", "sphere { 0, 1 scale 1e300 scale 1e300 }"},
        {"transforms that vanish", "sphere { 0, 1 scale 1e-300 scale 1e-300 }"},
        {"infinite number", "sphere { 0, 1e999 }"},
        {"undefined power", "sphere { 0, pow(-1, 0.5) }"},
        {"division by zero", "sphere { 0, 1/0 }"},
        {"a very long name", std::string(10'000'000, 'a')},
        {"a very long string", "#declare A = \"" + std::string(10'000'000, 'a') + "\";"},
        {"only hashes", repeated("#", 100'000)},
        {"a password file", "#include \"/etc/passwd\""},
        {"a folder above", "#include \"../../x\""},
        {"a folder above in disguise", "#include \"a/../../x\""},
        {"too many faces", "mesh2 { vertex_vectors { 1e10, 0"},
        {"too many Time steps", "#for (I, 0, 300000) sphere { <sin(I*Time), 0, 0>, 1 } #end"},
        {"redefined while read", "#macro F() #macro F() sphere { 0, 0 } #end #end F() F()"},
        {"undefined while read", "#macro F(A) #undef F #undef A A #end F(1)"},
    };
}

/// The issue's limits for any scene. Seconds of the process, since those on the clock depend on who else is at work.
/// A sanitizer makes memory accesses three times as slow or worse and keeps freed memory: more time, no limit of
/// memory.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr double kMostCpuSeconds = 25;
constexpr long kMostKilobytes = std::numeric_limits<long>::max();
#else
constexpr double kMostCpuSeconds = 5;
constexpr long kMostKilobytes = 1 << 20;
#endif

struct Outcome {
    std::string message;
    int status = 0;
    rusage used{};
};

/// A process of its own, so that its memory is its own and one that hangs is ended by the system.
Outcome outcome_of(const std::function<void()>& read_scene_in_child, double most_seconds) {
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("no pipe");
    const pid_t child = fork();
    if (child == 0) {
        const rlimit seconds{static_cast<rlim_t>(most_seconds) + 1, static_cast<rlim_t>(most_seconds) + 1};
        setrlimit(RLIMIT_CPU, &seconds);
        std::string message;
        try {
            read_scene_in_child();
        } catch (const InputError& error) {
            message = error.what();
        }
        const auto written = write(ends[1], message.data(), message.size());
        _exit(written == static_cast<ssize_t>(message.size()) ? 0 : 1);
    }
    close(ends[1]);
    Outcome outcome;
    char piece[4096];
    for (ssize_t n; (n = read(ends[0], piece, sizeof piece)) > 0;) {
        outcome.message.append(piece, static_cast<std::size_t>(n));
    }
    close(ends[0]);
    wait4(child, &outcome.status, 0, &outcome.used);
    return outcome;
}

void expect_bounded_error(const std::string& name, const std::function<void()>& read, double patience = 1) {
    const double most_seconds = patience * kMostCpuSeconds;
    const Outcome outcome = outcome_of(read, most_seconds);
    EXPECT_EQ(outcome.status, 0) << name << ": ended by signal " << WTERMSIG(outcome.status);
    const rusage& used = outcome.used;
    const double seconds = double(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
                           1e-6 * double(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
    EXPECT_LT(seconds, most_seconds) << name;
    EXPECT_LT(used.ru_maxrss, kMostKilobytes) << name;
    EXPECT_TRUE(std::regex_search(outcome.message.substr(0, 200), std::regex(R"(:\d+:\d+: \S+)")))
        << name << ": '" << outcome.message.substr(0, 300) << "'";
    EXPECT_LT(outcome.message.size(), 2000u) << name;
}

TEST(Hostile, ScenesEndInAnErrorWithAPlace) {
    for (const Hostile& hostile : hostile_scenes()) {
        expect_bounded_error(
            hostile.name, [&] { scene_of(hostile.text); }, hostile.patience);
    }
}

TEST(Hostile, CommittedScenes) {
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(RAYSTEPS_HOSTILE_SCENES)) {
        if (entry.path().extension() != ".pov") continue;
        ++count;
        expect_bounded_error(entry.path().filename(), [&] { read_scene(entry.path()); });
    }
    EXPECT_GE(count, 5);
}

TEST(Hostile, FilesThatAreNone) {
    for (const char* path : {"/dev/zero", "/nowhere/at/all.pov", "/"}) {
        expect_bounded_error(path, [&] { read_scene(path); });
    }
}

TEST(Hostile, EveryPrefixOfAScene) {
    const std::string scene =
        "#version 3.7; global_settings { assumed_gamma 1 }\n#macro M(A, B) sphere { A, B pigment { checker rgb 1, rgb "
        "0 } } #end\n"
        "#declare T = array[2] { <1,2,3>, x } #for (I, 0, 1) M(T[I], 1 + I) #end #if (1 < 2) box { -1, 1 } #else \"x\" "
        "#end\n"
        "camera { location <0, 1, -5> look_at 0 } light_source { 1, rgb 1 spotlight point_at 0 } /* end */";
    EXPECT_EQ(error_of(scene), "");
    for (std::size_t length = 0; length < scene.size(); ++length) {
        const std::string error = error_of(scene.substr(0, length));
        if (error.empty()) continue;
        EXPECT_TRUE(std::regex_search(error, std::regex(R"(^test\.pov:\d+:\d+: )"))) << error;
    }
}

TEST(Hostile, RandomChangesNeverCrash) {
    const std::string scene =
        "#declare R = seed(1); #declare A = array[2] { 1, 2 } #macro M(P) #local Q = P*2; (Q) #end #while (A[0] < 3) "
        "sphere { <M(A[0]), "
        "rand(R), 0>, 1 scale 2 texture { pigment { rgb <1, 0, 0> } finish { phong 1 } } } #declare A[0] = A[0] + 1; "
        "#end "
        "polygon { 4, <0,0>, <1,0>, <1,1>, <0,0> } mesh { triangle { 0, x, y } } union { sphere { 0, 1 } rotate 30*z }";
    const std::string letters = "{}()[]<>,;+-*/=!&|?:.#\"' 019exyzABR\n\\";
    std::mt19937 random(1);
    int errors = 0;
    for (int i = 0; i < 20'000; ++i) {
        std::string changed = scene;
        for (unsigned k = random() % 4 + 1; k > 0; --k) {
            const std::size_t at = random() % changed.size();
            switch (random() % 3) {
                case 0: changed[at] = letters[random() % letters.size()]; break;
                case 1: changed.erase(at, random() % 10 + 1); break;
                default: changed.insert(at, scene.substr(random() % scene.size(), random() % 20)); break;
            }
        }
        // A changed loop may need its whole allowance of work; a few such take minutes and teach nothing new.
        if (changed.find("#while (A[0] < 3)") == std::string::npos ||
            changed.find("#declare A[0] = A[0] + 1;") == std::string::npos)
            continue;
        errors += !error_of(changed).empty();
    }
    EXPECT_GT(errors, 5'000);
}

}  // namespace
}  // namespace rays
