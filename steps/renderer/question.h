// What answers to questions share: the words of a query, the scene that it is about, numbers as text.
#pragma once

#include <fmt/format.h>

#include <cstdlib>
#include <map>
#include <sstream>
#include <string>

#include "core/error.h"
#include "renderer/brute_force.h"
#include "renderer/render.h"
#include "scene_reader/scene_reader.h"

namespace rays::questions {

/// The words of one query, taken in order.
class Words {
public:
    explicit Words(const std::string& line) : in_(line) { in_ >> verb_; }
    const std::string& verb() const { return verb_; }

    std::string word() {
        std::string word;
        if (!(in_ >> word)) throw InputError(verb_ + ": too few words");
        return word;
    }
    Real number() { return number(word()); }
    Real number(const std::string& word) const {
        char* end = nullptr;
        const double value = std::strtod(word.c_str(), &end);  // takes "inf" and "nan" too: hostile rays are questions
        if (*end != '\0') throw InputError(verb_ + ": not a number: " + word);
        return static_cast<Real>(value);
    }
    int integer() { return static_cast<int>(number()); }
    /// A whole number from least to most, both included.
    template <class T>
    T whole(T least, T most) {
        const Real value = number();
        if (!(value >= Real(least) && value <= Real(most)))
            throw InputError(fmt::format("{}: {} is not from {} to {}", verb_, value, least, most));
        return static_cast<T>(value);
    }
    Vec3 vector() {
        const Real x = number(), y = number();
        return {x, y, number()};
    }
    Ray ray() {
        const Vec3 origin = vector();
        return {origin, vector()};
    }
    Interval interval() {
        const Real min = number();
        return {min, number()};
    }

private:
    std::istringstream in_;
    std::string verb_;
};

/// The shortest text that reads back as the same double.
inline std::string text(Real v) { return fmt::format("{}", static_cast<double>(v)); }
inline std::string text(const Vec3& v) { return text(v.x) + " " + text(v.y) + " " + text(v.z); }
inline std::string text(const Radiance& v) { return fmt::format("{:.9g} {:.9g} {:.9g}", v[0], v[1], v[2]); }
inline std::string text(bool v) { return v ? "1" : "0"; }

/// The scene in question, ready for queries.
struct Stage {
    explicit Stage(const std::string& sdl) : scene(read_scene_text(sdl, "question")) { prepare(scene); }

    const Object& object(Words& words) const { return scene.objects.at(index(words, scene.objects.size(), "object")); }
    const Light& light(Words& words) const { return scene.lights.at(index(words, scene.lights.size(), "light")); }
    const Material& material(Words& words) const { return scene.materials.at(object(words).material); }

    Scene scene;
    BruteForce intersector{scene};

private:
    static std::size_t index(Words& words, std::size_t count, const char* what) {
        const int i = words.integer();
        if (i < 0 || static_cast<std::size_t>(i) >= count) throw InputError(fmt::format("no {} {}", what, i));
        return static_cast<std::size_t>(i);
    }
};

using Answerer = std::string (*)(const Stage&, Words&);
/// By the query's first word.
using Answerers = std::map<std::string, Answerer, std::less<>>;

/// The queries of step 3.
void add_recursion(Answerers& answerers);
/// The queries of step 4.
void add_partitioning(Answerers& answerers);
/// The queries of step 5.
void add_distributed(Answerers& answerers);

}  // namespace rays::questions
