// SPDX-License-Identifier: Apache-2.0
#include "renderer/film/icc_transform.h"

#include <lcms2.h>
#include <lcms2_plugin.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <utility>

#include "renderer/spectrum/display.h"

namespace bouguer::renderer {
namespace {

constexpr std::size_t kMostBytes = 64U << 20U;

/// What the library has taken in one context.
struct Memory {
    std::size_t used = 0;
    bool is_refused = false;  ///< it has once wanted more than there is
};

/// What stands before every piece of memory that the library is given.
struct alignas(std::max_align_t) Piece {
    std::size_t size = 0;
    Memory* memory = nullptr;  ///< that it is part of; null for the context itself
};

Piece* piece_of(void* memory) { return static_cast<Piece*>(memory) - 1; }

void give_back(cmsContext /*context*/, void* memory) {
    if (memory == nullptr) return;
    Piece* piece = piece_of(memory);
    if (piece->memory != nullptr) piece->memory->used -= piece->size;
    std::free(piece);
}

void* take(cmsContext context, cmsUInt32Number size) {
    auto* memory = static_cast<Memory*>(cmsGetContextUserData(context));
    if (memory != nullptr && size > kMostBytes - memory->used) {
        memory->is_refused = true;
        return nullptr;
    }
    void* place = std::malloc(sizeof(Piece) + size);
    if (place == nullptr) return nullptr;
    auto* piece = ::new (place) Piece{size, memory};
    if (memory != nullptr) memory->used += size;
    return piece + 1;
}

void* take_anew(cmsContext context, void* memory, cmsUInt32Number size) {
    void* larger = take(context, size);
    if (larger == nullptr || memory == nullptr) return larger;
    const auto* from = static_cast<const char*>(memory);
    std::copy_n(from, std::min<std::size_t>(size, piece_of(memory)->size),
                static_cast<char*>(larger));
    give_back(context, memory);
    return larger;
}

cmsPluginMemHandler memory_handler() {
    cmsPluginMemHandler handler{};
    handler.base = {cmsPluginMagicNumber, 2000, cmsPluginMemHandlerSig, nullptr};
    handler.MallocPtr = &take;
    handler.FreePtr = &give_back;
    handler.ReallocPtr = &take_anew;
    return handler;
}

struct CloseProfile {
    void operator()(void* profile) const { cmsCloseProfile(profile); }
};
using Profile = std::unique_ptr<void, CloseProfile>;

Profile linear_rec709(cmsContext context) {
    const auto& c = find_display("rec709-linear")->chromaticities;
    const cmsCIExyY white{c[3].x, c[3].y, 1};
    const cmsCIExyYTRIPLE primaries{{c[0].x, c[0].y, 1}, {c[1].x, c[1].y, 1}, {c[2].x, c[2].y, 1}};
    cmsToneCurve* line = cmsBuildGamma(context, 1);
    const std::array curves{line, line, line};
    Profile profile(cmsCreateRGBProfileTHR(context, &white, &primaries, curves.data()));
    cmsFreeToneCurve(line);
    return profile;
}

bool is_of_colours(cmsProfileClassSignature kind) {
    return kind == cmsSigInputClass || kind == cmsSigDisplayClass || kind == cmsSigOutputClass ||
           kind == cmsSigColorSpaceClass;
}

/// Four letters.
std::string name_of(std::uint32_t signature) {
    std::string name;
    for (int shift = 24; shift >= 0; shift -= 8) {
        const char c = static_cast<char>(signature >> static_cast<unsigned>(shift) & 255U);
        name += c >= ' ' && c <= '~' ? c : '?';
    }
    return name;
}

void remove_elements(cmsHPROFILE profile) {
    for (const auto tag : {cmsSigDToB0Tag, cmsSigDToB1Tag, cmsSigDToB2Tag, cmsSigDToB3Tag})
        while (cmsIsTag(profile, tag) != 0 && cmsWriteTag(profile, tag, nullptr) != 0) {
        }
}

tl::unexpected<Error> refuse(const std::string& reason) {
    return fail(ErrorKind::InvalidInput, "the image's ICC profile " + reason, "bad-image");
}

}  // namespace

struct IccTransform::State {
    Memory memory;
    cmsContext context = nullptr;
    cmsHTRANSFORM transform = nullptr;
    int channels = 0;

    State() {
        auto handler = memory_handler();
        context = cmsCreateContext(&handler, &memory);
    }
    ~State() {
        if (transform != nullptr) cmsDeleteTransform(transform);
        if (context != nullptr) cmsDeleteContext(context);
    }
    State(const State&) = delete;
    State& operator=(const State&) = delete;
};

IccTransform::IccTransform(std::unique_ptr<State> state) : state_(std::move(state)) {}
IccTransform::~IccTransform() = default;
IccTransform::IccTransform(IccTransform&&) noexcept = default;
IccTransform& IccTransform::operator=(IccTransform&&) noexcept = default;

Result<IccTransform> IccTransform::to_linear_rec709(std::span<const std::uint8_t> profile) {
    auto state = std::make_unique<State>();
    if (state->context == nullptr)
        return fail(ErrorKind::Internal, "no memory for a colour profile");
    const Profile from(cmsOpenProfileFromMemTHR(state->context, profile.data(),
                                                static_cast<cmsUInt32Number>(profile.size())));
    if (!from) return refuse("cannot be read");
    const auto space = cmsGetColorSpace(from.get());
    if (space != cmsSigRgbData && space != cmsSigGrayData)
        return refuse("is one of " + name_of(space) + ", not of R, G, B or grey");
    if (!is_of_colours(cmsGetDeviceClass(from.get())))
        return refuse("is of the class " + name_of(cmsGetDeviceClass(from.get())) +
                      ", which describes no picture");
    remove_elements(from.get());
    const Profile to = linear_rec709(state->context);
    const bool is_grey = space == cmsSigGrayData;
    state->channels = is_grey ? 1 : 3;
    if (to)
        state->transform = cmsCreateTransformTHR(
            state->context, from.get(), is_grey ? TYPE_GRAY_FLT : TYPE_RGB_FLT, to.get(),
            TYPE_RGB_FLT, INTENT_RELATIVE_COLORIMETRIC, cmsFLAGS_NOOPTIMIZE | cmsFLAGS_NOCACHE);
    if (state->memory.is_refused) return refuse("wants more than 64 MiB of memory");
    if (state->transform == nullptr) return refuse("describes no colours");
    return IccTransform(std::move(state));
}

int IccTransform::channels() const { return state_->channels; }

void IccTransform::operator()(std::span<const float> from, std::span<float> to) const {
    cmsDoTransform(state_->transform, from.data(), to.data(),
                   static_cast<cmsUInt32Number>(to.size() / 3));
}

}  // namespace bouguer::renderer
