// What a name of the language can stand for.
#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "scene_reader/affine.h"
#include "scene_reader/source.h"
#include "scene_reader/words.h"

namespace rays::sdl {

/// One to five floats: float, 2D vector, vector, 4D vector, colour (red, green, blue, filter, transmit).
struct Numbers {
    double at[5] = {0, 0, 0, 0, 0};
    int count = 1;

    V3 xyz() const { return {at[0], at[1], at[2]}; }
};

struct Value;

/// Up to five dimensions, elements of one kind. Assigning an array copies it; its elements have fixed addresses.
struct Array : std::enable_shared_from_this<Array> {
    std::vector<std::size_t> sizes;
    std::vector<Value> elements;
};

/// Text that is read again with its parameters bound. A function is the same with one expression as its body.
struct Macro {
    std::string name;
    std::vector<NameId> parameters;
    const Source* source = nullptr;
    const char* body = nullptr;
    const char* body_end = nullptr;  ///< macro: the '#' of its #end; function: the closing brace
};
class Formula;
struct Function : Macro {
    /// The variables of its expression, with the values they had when it was defined.
    std::vector<std::pair<NameId, std::shared_ptr<Value>>> captured;
    bool internal = false;  ///< one of POV-Ray's built-in functions: can be named but not called
    std::shared_ptr<const Formula> formula;  ///< what it computes, if that is known without its text
};

/// A macro's parameter that is the caller's own variable.
struct Reference {
    std::shared_ptr<Value> target;
};

/// What one of POV-Ray's include files declares and Raysteps does not know. Only who uses it gets an error.
struct Unusable {
    Place place;
    std::string why;
};

struct SurfaceDraft;
struct PigmentDraft;
struct InteriorDraft;
struct MediaDraft;
struct DensityDraft;
struct MaterialDraft;
struct ObjectDraft;
struct FinishDraft;
struct CameraDraft;

template <class T>
using Shared = std::shared_ptr<const T>;

struct Value {
    std::variant<std::monostate, Numbers, std::string, std::shared_ptr<Array>, Shared<Macro>, Shared<Function>,
                 Reference, Shared<Affine>, Shared<CameraDraft>, Shared<ObjectDraft>, Shared<SurfaceDraft>,
                 Shared<PigmentDraft>, Shared<FinishDraft>, Shared<InteriorDraft>, Shared<MediaDraft>,
                 Shared<DensityDraft>, Shared<MaterialDraft>, Shared<Unusable>>
        is;

    bool empty() const { return is.index() == 0; }
    template <class T>
    const T* as() const {
        return std::get_if<T>(&is);
    }
    template <class T>
    T* as() {
        return std::get_if<T>(&is);
    }
    /// The thing behind Shared<T>, or null.
    template <class T>
    Shared<T> shared() const {
        const auto* held = std::get_if<Shared<T>>(&is);
        return held ? *held : nullptr;
    }
};

/// "a float", "a vector", "a texture", ... for messages.
std::string kind_name(const Value& value);

}  // namespace rays::sdl
