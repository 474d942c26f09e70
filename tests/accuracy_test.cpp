// Mappers that claim an accuracy instead of exact texels.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <limits>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "spec/law_tools.h"
#include "spec/promise.h"
#include "spec/verify.h"

namespace selvage::spec {
namespace {

[[nodiscard]] int32_t added(int32_t coordinate, int64_t by) {
  using Limits = std::numeric_limits<int32_t>;
  return static_cast<int32_t>(std::clamp<int64_t>(coordinate + by, Limits::min(), Limits::max()));
}

struct Offset {
  int64_t u_fx16, v_fx16;
};

// The mapper that this program is linked with, in each call its u and v off by offset_of(...).
template <class OffsetOf>
[[nodiscard]] Subject off_by(const OffsetOf& offset_of) {
  Subject subject = built_in();
  subject.draw = [=](const selvage_image* target, const selvage_rect* clip,
                     const selvage_vertex* vertices, size_t count, const selvage_texture* texture,
                     const selvage_options* options) {
    std::vector<selvage_vertex> moved(vertices, vertices + count);
    const Offset offset = offset_of(clip, moved, *texture, *options);
    for (selvage_vertex& v : moved) {
      v.u = added(v.u, offset.u_fx16);
      v.v = added(v.v, offset.v_fx16);
    }
    return selvage_draw(target, clip, moved.data(), count, texture, options);
  };
  subject.draw_many = {};
  subject.choose = {};
  subject.claims.named_errors = false;  // all arguments are looked at
  return subject;
}

[[nodiscard]] Subject off_by(int64_t u_fx16, int64_t v_fx16) {
  return off_by([=](const auto&...) { return Offset{u_fx16, v_fx16}; });
}

// By something else in each drawing, as rounding is that depends on where it begins; at most by
// so much.
[[nodiscard]] Subject off_at_random_by(int32_t most_fx16) {
  return off_by([=](const selvage_rect* clip, const std::vector<selvage_vertex>& vertices,
                    const selvage_texture& texture, const selvage_options& options) {
    uint32_t hash = 1;
    const auto add = [&](auto... values) {
      ((hash = (hash ^ static_cast<uint32_t>(values)) * 0x9E3779B1U, hash ^= hash >> 15), ...);
    };
    if (clip != nullptr) add(clip->left, clip->top, clip->right, clip->bottom);
    for (const selvage_vertex& v : vertices) add(v.x, v.y, v.u, v.v, v.q);
    add(texture.layout, texture.pitch, options.kernel);
    Choices choices(hash);
    const auto some = [&] { return int64_t{choices.pick(-most_fx16, most_fx16 + 1)}; };
    return Offset{some(), some()};
  });
}

[[nodiscard]] Subject claiming(Subject subject, int32_t accuracy_fx16) {
  subject.claims.accuracy_fx16 = accuracy_fx16;
  return subject;
}

[[nodiscard]] bool is_promised_by(const Subject& subject, std::string_view law) {
  return promise(subject.profile, subject.claims, law).standing == Standing::kPromised;
}

[[nodiscard]] bool rejects(std::string_view law, const Subject& subject) {
  return verify(*find_law(law), subject, 1, 1000).violation.has_value();
}

constexpr int32_t kFew_fx16 = 1, kSome_fx16 = 5000, kHalf_fx16 = 32767, kMany_fx16 = 200000;

// To the last unit: 1/65536 texel of u more is a texel more where u is whole.
TEST(AccuracyOfASubject, IsKeptByOneThatIsOffBySoMuch) {
  for (const int32_t off_fx16 : {kFew_fx16, -kSome_fx16, kHalf_fx16, -kMany_fx16}) {
    const int32_t accuracy_fx16 = std::abs(off_fx16);
    const Subject subject = claiming(off_by(off_fx16, -off_fx16), accuracy_fx16);
    for (const Law& law : laws()) {
      if (!is_promised_by(subject, law.name)) continue;
      const LawVerdict verdict = verify(law, subject, 1, 150);
      EXPECT_FALSE(verdict.violation) << explain(*verdict.violation);
      EXPECT_GT(verdict.judged_px, 0u) << law.name;
      if (law.name != "MAP" || accuracy_fx16 == kFew_fx16) continue;  // few pixels are so near
      ASSERT_TRUE(verdict.margin);
      EXPECT_GT(verdict.margin->share(), 0.5);
    }
  }
}

// No two of its drawings are alike.
TEST(AccuracyOfASubject, IsKeptByOneThatIsOffAtRandomWithinIt) {
  for (const int32_t accuracy_fx16 : {kSome_fx16, kHalf_fx16, kMany_fx16}) {
    const Subject subject = off_at_random_by(accuracy_fx16),
                  within = claiming(subject, accuracy_fx16);
    for (const Law& law : laws()) {
      if (!is_promised_by(within, law.name)) continue;
      const LawVerdict verdict = verify(law, within, 1, 150);
      EXPECT_FALSE(verdict.violation) << explain(*verdict.violation);
      EXPECT_GT(verdict.judged_px, 0u) << law.name;
      const bool is_of_texels =
          law.name != "COV" && law.name != "PART" && law.name != "PINWHEEL" && law.name != "MEM";
      if (accuracy_fx16 != kMany_fx16) continue;
      EXPECT_EQ(verify(law, subject, 1, 150).violation.has_value(), is_of_texels) << law.name;
    }
  }
}

TEST(AccuracyOfASubject, IsNotKeptByOneThatIsOffByTwiceAsMuch) {
  for (const int32_t accuracy_fx16 : {256, kSome_fx16, kHalf_fx16, kMany_fx16}) {
    for (const int64_t off_fx16 : {-2 * accuracy_fx16, 2 * accuracy_fx16}) {
      for (const char* law : {"VERT", "MAP"}) {
        EXPECT_TRUE(rejects(law, claiming(off_by(off_fx16, 0), accuracy_fx16))) << law;
        EXPECT_TRUE(rejects(law, claiming(off_by(0, off_fx16), accuracy_fx16))) << law;
      }
    }
  }
}

TEST(AccuracyOfASubject, IsNoneByDefault) {
  EXPECT_TRUE(rejects("MAP", off_by(1, 0)));
  EXPECT_TRUE(shows_exact_texels(Capabilities{}));
}

// Where rounding decides nothing, whole texels do.
TEST(AccuracyOfASubject, LetsOtherLawsRejectWhatIsFarOff) {
  for (const char* law : {"GAMUT", "IDENTITY", "TOLERANCE", "ORACLE"}) {
    if (find_law(law) == nullptr) continue;  // a build without OpenCV has no oracle
    EXPECT_TRUE(rejects(law, claiming(off_by(SELVAGE_SUBTEXELS, 0), 256))) << law;
    EXPECT_TRUE(rejects(law, claiming(off_by(0, -SELVAGE_SUBTEXELS), 256))) << law;
  }
}

// The mapper that this program is linked with, its arguments changed before it draws.
struct Arguments {
  std::vector<selvage_vertex> vertices;
  selvage_texture texture;
  selvage_options options;
};
using Change = std::function<void(Arguments&)>;

[[nodiscard]] Subject changed(const Change& change) {
  Subject subject = claiming(off_by(0, 0), 256);
  subject.draw = [=](const selvage_image* target, const selvage_rect* clip,
                     const selvage_vertex* vertices, size_t count, const selvage_texture* texture,
                     const selvage_options* options) {
    Arguments a{{vertices, vertices + count}, *texture, *options};
    change(a);
    return selvage_draw(target, clip, a.vertices.data(), count, &a.texture, &a.options);
  };
  return subject;
}

// Vertices off by it, each another way: in narrow polygons the area filter's box is another one.
TEST(AccuracyOfASubject, IsKeptByOneWhoseVerticesAreOffByIt) {
  Subject subject = claiming(changed([](Arguments& a) {
                               for (size_t i = 0; i < a.vertices.size(); ++i) {
                                 const int32_t by_fx16 = i % 2 == 0 ? 4096 : -4096;
                                 a.vertices[i].u = added(a.vertices[i].u, by_fx16);
                                 a.vertices[i].v = added(a.vertices[i].v, -by_fx16);
                               }
                             }),
                             4096);
  subject.claims.filters = only(SELVAGE_FILTER_NEAREST) | only(SELVAGE_FILTER_AREA);
  const LawVerdict verdict = verify(*find_law("FILTER"), subject, 21, 600);
  EXPECT_FALSE(verdict.violation) << explain(*verdict.violation);
}

// What is wrong by no rounding is wrong within an accuracy, too.
TEST(AccuracyOfASubject, LetsFilterRejectWhatIsNoRounding) {
  const auto with_filter = [](const auto& change) {
    return changed([=](Arguments& a) {
      if (a.options.filter != SELVAGE_FILTER_NEAREST) change(a);
    });
  };
  const Subject wrong[] = {
      with_filter([](Arguments& a) {
        for (selvage_vertex& v : a.vertices) v.u = added(v.u, SELVAGE_SUBTEXELS / 2);
      }),
      with_filter([](Arguments& a) {
        for (selvage_vertex& v : a.vertices) v.v = added(v.v, -1024);
      }),
      with_filter([](Arguments& a) { a.options.filter = SELVAGE_FILTER_NEAREST; }),
      with_filter([](Arguments& a) {
        for (selvage_vertex& v : a.vertices) std::swap(v.u, v.v);
      }),
      with_filter([](Arguments& a) { a.options.address = 1 - a.options.address; }),
      with_filter([](Arguments& a) {
        for (selvage_vertex& v : a.vertices) v.q = 1;
      }),
      changed([](Arguments& a) {
        if (a.options.filter == SELVAGE_FILTER_AREA) a.options.filter = SELVAGE_FILTER_BILINEAR;
      }),
      changed([](Arguments& a) {
        if (a.options.filter == SELVAGE_FILTER_FOUR) a.options.filter = SELVAGE_FILTER_BILINEAR;
      }),
  };
  for (size_t i = 0; i < std::size(wrong); ++i) EXPECT_TRUE(rejects("FILTER", wrong[i])) << i;
}

// Of many polygons at once, each with its own texture and (u, v).
TEST(AccuracyOfASubject, LetsSameRejectWhatIsWrongInOneCallAlone) {
  using Polygons = std::vector<selvage_polygon>;
  const auto in_one_call = [](const std::function<void(Polygons&, selvage_options&, int32_t)>& to) {
    Subject subject = claiming(built_in(), 256);
    subject.draw_many = [right = subject.draw_many, to](
                            const selvage_image* target, const selvage_rect* clip,
                            const selvage_polygon* polygons, size_t count,
                            const selvage_options* options, int32_t threads, size_t* failed) {
      Polygons all(polygons, polygons + count);
      selvage_options changed = *options;
      to(all, changed, threads);
      return right(target, clip, all.data(), count, &changed, threads, failed);
    };
    return subject;
  };
  EXPECT_FALSE(rejects("SAME", in_one_call([](Polygons&, selvage_options&, int32_t) {})));
  const Subject wrong[] = {
      in_one_call([](Polygons& all, selvage_options&, int32_t) {
        for (selvage_polygon& polygon : all) polygon.texture = all[0].texture;
      }),
      in_one_call([](Polygons& all, selvage_options&, int32_t threads) {
        if (threads == 3) std::ranges::reverse(all);
      }),
      in_one_call([](Polygons&, selvage_options& options, int32_t threads) {
        if (threads == 8) options.address = 1 - options.address;
      }),
      in_one_call([](Polygons&, selvage_options& options, int32_t) {
        options.filter = SELVAGE_FILTER_NEAREST;
      }),
  };
  for (size_t i = 0; i < std::size(wrong); ++i) {
    const LawVerdict verdict = verify(*find_law("SAME"), wrong[i], 1, 1000);
    ASSERT_TRUE(verdict.violation) << i;
    ASSERT_TRUE(verdict.violation->comparison) << "there is a picture of it";
    const Comparison& comparison = *verdict.violation->comparison;
    EXPECT_NE(comparison.drawn.at(verdict.violation->x_px, verdict.violation->y_px),
              comparison.wanted.at(verdict.violation->x_px, verdict.violation->y_px));
  }
}

// Known again by where it is on the screen: the last polygon of a scene is where the one before is.
TEST(AccuracyOfASubject, LetsSameRejectTheCoordinatesOfAnotherPolygon) {
  const auto last = std::make_shared<std::vector<selvage_vertex>>();
  EXPECT_TRUE(rejects("SAME", changed([last](Arguments& a) {
                        const auto is_there = [](const selvage_vertex& v, const selvage_vertex& w) {
                          return v.x == w.x && v.y == w.y;
                        };
                        if (std::ranges::equal(a.vertices, *last, is_there)) {
                          a.vertices = *last;
                        } else {
                          *last = a.vertices;
                        }
                      })));
}

// Half a texel from its centre is another texel's.
TEST(AccuracyOfASubject, TakesSomeLawsTheirSay) {
  const auto within = [](int32_t accuracy_fx16) { return claiming(off_by(0, 0), accuracy_fx16); };
  EXPECT_TRUE(is_promised_by(within(SELVAGE_SUBTEXELS / 2 - 1), "IDENTITY"));
  EXPECT_FALSE(is_promised_by(within(SELVAGE_SUBTEXELS / 2), "IDENTITY"));
  EXPECT_TRUE(is_promised_by(within(SELVAGE_SUBTEXELS / 4 - 1), "ORACLE"));
  EXPECT_FALSE(is_promised_by(within(SELVAGE_SUBTEXELS / 4), "ORACLE"));
  EXPECT_TRUE(is_promised_by(within(SELVAGE_SUBTEXELS - 1), "SAME"));
  EXPECT_FALSE(is_promised_by(within(SELVAGE_SUBTEXELS), "SAME"));
  EXPECT_EQ(verify(*find_law("SAME"), within(1 << 30), 1, 20).judged_px, 0u)
      << "asked all the same";
  const Subject far = within(SELVAGE_SUBTEXELS);
  for (const char* law : {"MAP", "CLIP", "FILTER"}) {
    EXPECT_TRUE(is_promised_by(far, law));
    EXPECT_FALSE(promise(SELVAGE_PROFILE_EXACT, far.claims, law).note.empty()) << law;
  }
  Capabilities affine = far.claims;
  affine.perspective = false;
  EXPECT_EQ(promise(SELVAGE_PROFILE_EXACT, affine, "AFFINE").note,
            promise(SELVAGE_PROFILE_EXACT, far.claims, "AFFINE").note)
      << "it compares no texels, whatever else it does not";
}

}  // namespace
}  // namespace selvage::spec
