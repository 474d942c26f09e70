// selvage_draw_many and every bad argument: the right error, the right polygon, and nothing drawn.
#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <string>

#include "support.h"

namespace selvage::many {
namespace {

inline constexpr size_t kPolygons = 3000;  // several runs, so that errors meet
inline constexpr size_t kNobody = 12345;

// A call that is right, to be spoiled.
struct Call {
  List list{kPolygons, /*seed=*/1};
  Target picture;
  Scratch scratch{kPolygons};
  selvage_image target = picture.image();
  selvage_options options{};
  const selvage_image* target_pointer = &target;
  const selvage_polygon* polygons = list.polygons.data();
  size_t count = kPolygons;
  int32_t threads = 1;
  void* scratch_pointer = scratch.memory.data();
  size_t scratch_bytes = scratch.bytes;
  size_t failed = kNobody;
  // Room that begins as aligned as scratch memory must be.
  std::vector<std::max_align_t> room{2 * selvage_draw_many_bytes(kPolygons) / 16};

  selvage_status draw() {
    return selvage_draw_many(target_pointer, nullptr, polygons, count, &options, threads,
                             scratch_pointer, scratch_bytes, &failed);
  }
  // Moves the scratch memory to the room, and returns the address so many bytes from its start.
  void* in_scratch(size_t offset = 0) {
    scratch_pointer = room.data();
    return reinterpret_cast<char*>(room.data()) + offset;
  }
};

struct Refusal {
  std::string what;
  selvage_status wanted;
  size_t failed;
  std::function<void(Call&)> spoil;
};

void PrintTo(const Refusal& refusal, std::ostream* os) { *os << refusal.what; }

class Refusals : public testing::TestWithParam<Refusal> {};

TEST_P(Refusals, NameTheErrorAndDrawNothing) {
  const auto& [what, wanted, failed, spoil] = GetParam();
  for (const int32_t threads : {1, 4}) {
    Call call;
    call.threads = threads;
    spoil(call);
    const Target before = call.picture;
    EXPECT_EQ(call.draw(), wanted) << threads << " threads";
    EXPECT_EQ(call.failed, failed);
    EXPECT_TRUE(call.picture == before);
    EXPECT_TRUE(call.scratch.guard_is_intact());
  }
}

const Refusal kOfTheCall[] = {
    {"an unknown profile", SELVAGE_ERROR_PROFILE, kNobody, [](Call& c) { c.options.profile = 9; }},
    {"an unknown filter", SELVAGE_ERROR_FILTER, kNobody, [](Call& c) { c.options.filter = -1; }},
    {"no target", SELVAGE_ERROR_TARGET_NULL, kNobody, [](Call& c) { c.target_pointer = nullptr; }},
    {"a short pitch", SELVAGE_ERROR_TARGET_PITCH, kNobody, [](Call& c) { c.target.pitch = 4; }},
    {"negative threads", SELVAGE_ERROR_THREADS, kNobody, [](Call& c) { c.threads = -1; }},
    {"least threads", SELVAGE_ERROR_THREADS, kNobody, [](Call& c) { c.threads = INT32_MIN; }},
    {"negative threads and no polygons", SELVAGE_ERROR_THREADS, kNobody,
     [](Call& c) { c.threads = -1, c.count = 0; }},
    {"no polygons", SELVAGE_ERROR_POLYGONS_NULL, kNobody, [](Call& c) { c.polygons = nullptr; }},
    {"polygons in the target", SELVAGE_ERROR_OVERLAP, kNobody,
     [](Call& c) { c.polygons = static_cast<const selvage_polygon*>(c.target.pixels); }},
    {"polygons in all of memory", SELVAGE_ERROR_OVERLAP, kNobody,
     [](Call& c) {
       c.count = SIZE_MAX;
       c.polygons = reinterpret_cast<const selvage_polygon*>(uintptr_t{24});
     }},
    {"no scratch memory", SELVAGE_ERROR_SCRATCH_NULL, kNobody,
     [](Call& c) { c.scratch_pointer = nullptr; }},
    {"crooked scratch memory", SELVAGE_ERROR_SCRATCH_ALIGNMENT, kNobody,
     [](Call& c) { c.scratch_pointer = c.scratch.memory.data() + alignof(std::max_align_t) / 2; }},
    {"too little scratch memory", SELVAGE_ERROR_SCRATCH_SIZE, kNobody,
     [](Call& c) { --c.scratch_bytes; }},
    {"scratch memory in the target", SELVAGE_ERROR_SCRATCH_OVERLAP, kNobody,
     [](Call& c) { c.target.pixels = c.in_scratch(64); }},
    {"scratch memory on the polygons", SELVAGE_ERROR_SCRATCH_OVERLAP, kNobody,
     [](Call& c) {
       c.polygons = static_cast<const selvage_polygon*>(c.in_scratch(c.scratch_bytes - 8));
     }},
};

const Refusal kOfAPolygon[] = {
    {"no texture", SELVAGE_ERROR_TEXTURE_NULL, 7,
     [](Call& c) { c.list.polygons[7].texture = nullptr; }},
    {"no texels", SELVAGE_ERROR_TEXTURE_NULL, 2999,
     [](Call& c) {
       static const selvage_texture none{};
       c.list.polygons[2999].texture = &none;
     }},
    {"another format", SELVAGE_ERROR_FORMAT_MISMATCH, 0,
     [](Call& c) {
       for (auto& texture : c.list.textures) texture.format = SELVAGE_INDEX8;
     }},
    {"texels in the target", SELVAGE_ERROR_OVERLAP, 0,
     [](Call& c) {
       for (auto& texture : c.list.textures) texture.texels = c.target.pixels;
     }},
    {"a texture described in the target", SELVAGE_ERROR_OVERLAP, 9,
     [](Call& c) {
       c.list.polygons[9].texture = static_cast<const selvage_texture*>(c.target.pixels);
     }},
    {"vertices in the target", SELVAGE_ERROR_OVERLAP, 2500,
     [](Call& c) {
       c.list.polygons[2500].vertices = static_cast<const selvage_vertex*>(c.target.pixels);
     }},
    {"no vertices", SELVAGE_ERROR_VERTICES_NULL, 0,
     [](Call& c) { c.list.polygons[0].vertices = nullptr; }},
    {"too few vertices", SELVAGE_ERROR_VERTEX_COUNT, 1024,
     [](Call& c) { c.list.polygons[1024].count = 2; }},
    {"vertices in all of memory", SELVAGE_ERROR_OVERLAP, 5,
     [](Call& c) {
       c.list.polygons[5].vertices = reinterpret_cast<const selvage_vertex*>(uintptr_t{20});
       c.list.polygons[5].count = SIZE_MAX;
     }},
    {"two that are bad: the first counts", SELVAGE_ERROR_VERTEX_Q, 2000,
     [](Call& c) {
       c.list.vertices[3 * 2000].q = 0;
       c.list.polygons[2001].count = 0;
       c.list.polygons[2900].texture = nullptr;
     }},
    {"a position out of range", SELVAGE_ERROR_VERTEX_POSITION, 1,
     [](Call& c) { c.list.vertices[5].x = SELVAGE_X_END; }},
    {"a fraction of a pixel", SELVAGE_ERROR_VERTEX_FRACTION, 0,
     [](Call& c) { c.options.profile = SELVAGE_PROFILE_DKIT; }},
    {"vertices in scratch memory", SELVAGE_ERROR_SCRATCH_OVERLAP, 2999,
     [](Call& c) {
       c.list.polygons[2999].vertices = static_cast<const selvage_vertex*>(c.in_scratch(4));
     }},
    {"a texture described in scratch memory", SELVAGE_ERROR_SCRATCH_OVERLAP, 30,
     [](Call& c) {
       c.list.polygons[30].texture = static_cast<const selvage_texture*>(c.in_scratch());
     }},
    {"texels in scratch memory", SELVAGE_ERROR_SCRATCH_OVERLAP, 0,
     [](Call& c) {
       for (auto& texture : c.list.textures) texture.texels = c.in_scratch(c.scratch_bytes - 4);
     }},
};

INSTANTIATE_TEST_SUITE_P(OfTheCall, Refusals, testing::ValuesIn(kOfTheCall));
INSTANTIATE_TEST_SUITE_P(OfAPolygon, Refusals, testing::ValuesIn(kOfAPolygon));

// What lies just beside the scratch memory that is used is none of its affair.
TEST(Scratch, EndsWhereItIsNoLongerNeeded) {
  Call call;
  void* const end = call.in_scratch(call.scratch_bytes);
  call.list.textures[0].texels = end;
  call.scratch_bytes = call.room.size() * sizeof call.room[0];
  EXPECT_EQ(call.draw(), SELVAGE_OK);
}

TEST(Scratch, GrowsWithThePolygonsUpToWhatCanBe) {
  EXPECT_GT(selvage_draw_many_bytes(1), 0U);
  EXPECT_GT(selvage_draw_many_bytes(2), selvage_draw_many_bytes(1));
  EXPECT_EQ(selvage_draw_many_bytes(64'000), 1000 * selvage_draw_many_bytes(64));
  EXPECT_LE(selvage_draw_many_bytes(64'000), 64'000 * 100U);
  constexpr size_t kMost = sizeof(size_t) == 8 ? 400'000'000 : 25'000'000;
  EXPECT_LT(selvage_draw_many_bytes(kMost), SIZE_MAX / 2 + 1);
  EXPECT_EQ(selvage_draw_many_bytes(400'000'001), SIZE_MAX);
  EXPECT_EQ(selvage_draw_many_bytes(SIZE_MAX), SIZE_MAX);
  EXPECT_EQ(selvage_draw_many_bytes(UINT32_MAX), SIZE_MAX);
  Call call;
  call.count = UINT32_MAX;
  call.scratch_bytes = SIZE_MAX;
  call.polygons = reinterpret_cast<const selvage_polygon*>(UINTPTR_MAX - 7);  // clear of the target
  EXPECT_EQ(call.draw(), SELVAGE_ERROR_SCRATCH_SIZE);
}

TEST(Refusal, NeedNotSayWhichPolygonFailed) {
  Call call;
  call.list.polygons[7].count = 0;
  EXPECT_EQ(call.draw(), SELVAGE_ERROR_VERTEX_COUNT);
  EXPECT_EQ(call.failed, 7U);
  EXPECT_EQ(selvage_draw_many(&call.target, nullptr, call.polygons, call.count, &call.options, 1,
                              call.scratch_pointer, call.scratch_bytes, nullptr),
            SELVAGE_ERROR_VERTEX_COUNT);
}

// Options, target, threads, polygons, scratch memory, then the polygons: each hides the later ones.
TEST(Refusal, TheFirstErrorIsTheOneReported) {
  Call call;
  call.options.tolerance = -1;
  call.target.width = 0;
  call.threads = -1;
  call.polygons = nullptr;
  call.scratch_pointer = nullptr;
  call.list.polygons[0].count = 0;
  EXPECT_EQ(call.draw(), SELVAGE_ERROR_TOLERANCE);
  call.options.tolerance = 0;
  EXPECT_EQ(call.draw(), SELVAGE_ERROR_TARGET_SIZE);
  call.target.width = kWidth_px;
  EXPECT_EQ(call.draw(), SELVAGE_ERROR_THREADS);
  call.threads = 2;
  EXPECT_EQ(call.draw(), SELVAGE_ERROR_POLYGONS_NULL);
  call.polygons = call.list.polygons.data();
  EXPECT_EQ(call.draw(), SELVAGE_ERROR_SCRATCH_NULL);
  call.scratch_pointer = call.scratch.memory.data() + 1;
  call.scratch_bytes = 0;
  EXPECT_EQ(call.draw(), SELVAGE_ERROR_SCRATCH_ALIGNMENT);
  call.scratch_pointer = call.scratch.memory.data();
  EXPECT_EQ(call.draw(), SELVAGE_ERROR_SCRATCH_SIZE);
  call.scratch_bytes = call.scratch.bytes;
  EXPECT_EQ(call.failed, kNobody);
  EXPECT_EQ(call.draw(), SELVAGE_ERROR_VERTEX_COUNT);
  EXPECT_EQ(call.failed, 0U);
  call.list.polygons[0].count = 3;
  EXPECT_EQ(call.draw(), SELVAGE_OK);
}

}  // namespace
}  // namespace selvage::many
