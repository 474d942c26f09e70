// The document: everything in one file but the pictures, nothing from outside its folder.
#include "reports/page/html.h"
#include "reports/page/matrix.h"
#include "reports/page/scenes.h"
#include "reports/page/sections.h"

namespace selvage::reports {

namespace {

constexpr const char* kStyle = R"(
:root { color-scheme: light dark; --text: #1d2228; --page: #fdfdfb; --line: #d5d8dc;
        --good: #14713a; --bad: #b3152a; --soft: #f0f1f3; }
@media (prefers-color-scheme: dark) {
  :root { --text: #dfe3e8; --page: #14171c; --line: #363c45; --good: #58c983; --bad: #ff7a85;
          --soft: #1f242b; } }
body { margin: 0 auto; max-width: 80rem; padding: 1rem 1.25rem 4rem; background: var(--page);
       color: var(--text); font: 16px/1.5 system-ui, sans-serif; }
h2 { margin-top: 2.5rem; border-bottom: 1px solid var(--line); }
h3 { margin: 2rem 0 .3rem; }
p, li { max-width: 52rem; }
a { color: inherit; }
.good { color: var(--good); } .bad { color: var(--bad); font-weight: 600; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-size: .92rem; font-variant-numeric: tabular-nums; }
th, td { padding: .25rem .7rem; border-bottom: 1px solid var(--line); text-align: left;
         vertical-align: top; }
td.n, th.n { text-align: right; white-space: nowrap; }
.seen { background: var(--soft); } .seen code { overflow-wrap: anywhere; }
.three { display: grid; grid-template-columns: repeat(auto-fit, minmax(15rem, 1fr)); gap: .8rem; }
.two { display: grid; gap: .8rem; margin: .8rem 0;
       grid-template-columns: repeat(auto-fit, minmax(min(24rem, 100%), 1fr)); }
.five { display: grid; gap: .8rem; grid-template-columns: repeat(auto-fit, minmax(13rem, 1fr)); }
.two img, .five img { width: 100%; background: #060914; }
.legend { list-style: none; margin: .3rem 0; padding: 0; } .five .legend { font-size: .78rem; }
.legend li { padding-left: 1.4rem; text-indent: -1.4rem; }
.swatch { display: inline-block; width: .9rem; height: .9rem; margin-right: .5rem;
          vertical-align: -.1rem; border-radius: .15rem; }
figure { margin: 0; } figcaption { font-size: .85rem; }
img { max-width: 100%; height: auto; display: block; }
.three img { width: 100%; background: #181c26; }
.plot { width: 41.25rem; margin: .5rem 0; }
.plots { display: grid; gap: 1.5rem;
         grid-template-columns: repeat(auto-fit, minmax(min(34rem, 100%), 1fr)); }
.plots .plot { width: 100%; }
.stability td, .stability th.n { padding: .25rem .45rem; }
.stability .reason { min-width: 15rem; }
.reason small { font-weight: normal; } .reason code { font-size: .75rem; overflow-wrap: anywhere; }
.worst { display: grid; gap: 1rem;
         grid-template-columns: repeat(auto-fit, minmax(min(24rem, 100%), 1fr)); }
.worst code { overflow-wrap: anywhere; } .worst img { background: #181818; }
pre { background: var(--soft); padding: .8rem 1rem; overflow-x: auto; font-size: .85rem; }
pre.replay { white-space: pre-wrap; overflow-wrap: anywhere; }
summary { cursor: pointer; } details { margin: .8rem 0; }
.reaching { margin-inline: calc(min(0px, 40rem - 50vw + .5rem)); }
.matrix td, .matrix th { padding: .2rem .16rem; font-size: .8rem; }
.matrix tr:first-child th { font-size: .68rem; } .matrix small { font-size: .68rem; }
.matrix th:first-child { position: sticky; left: 0; background: var(--page); min-width: 7.5rem; }
.matrix small { display: block; font-weight: normal; } .differs { background: var(--soft); }
.quiet { opacity: .65; } .enlarged { image-rendering: pixelated; margin-top: .8rem; }
)";

}  // namespace

std::string document(const std::string& title, const std::string& body) {
  const std::string head =
      "<meta charset=utf-8>\n"
      "<meta name=viewport content=\"width=device-width, initial-scale=1\">\n" +
      element("title", title) + element("style", kStyle);
  return "<!doctype html>\n" +
         element("html", element("head", head) + element("body", body), "lang=en");
}

std::string page(const Results& results) {
  const std::string body = summary_section(results) + scenes_section(results.scenes) +
                           verdict_section(results) + matrix_section(results.matrix) +
                           gallery_section(results) + stability_section(results) +
                           measurement_section(results) + method_section(results);
  return document("Selvage: verdicts, pictures, measurements", body);
}

}  // namespace selvage::reports
