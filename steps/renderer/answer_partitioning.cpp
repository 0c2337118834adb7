// The queries of step 4: boxes, cells and octants one by one, and whole structures.
#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <sys/time.h>

#include <barrier>
#include <thread>

#include "4_partitioning/effort.h"
#include "4_partitioning/structures.h"
#include "renderer/agreement.h"
#include "renderer/question.h"

namespace rays::questions {
namespace {

/// Answers have room for this many numbers.
constexpr std::size_t kMostNumbers = 64;

Bounds box(Words& words) {
    const Vec3 min = words.vector();
    return {min, words.vector()};
}
std::string text(const Bounds& b) { return questions::text(b.min) + " " + questions::text(b.max); }

GridSpace space(Words& words) {
    GridSpace result;
    result.box = box(words);
    for (int& n : result.cells) n = words.integer();
    for (const int n : result.cells)
        if (n < 1 || n > kMostCells) throw InputError(fmt::format("{} cells along an axis", n));
    return result;
}

std::string bounds(const Stage& stage, Words& words) {
    const auto primitives = primitives_of(stage.scene);
    const auto i = static_cast<std::size_t>(words.integer());
    if (i >= primitives.size()) throw InputError(fmt::format("no primitive {}", i));
    return text(bounds_of(stage.scene, primitives[i]));
}

std::string clipped(const Stage&, Words& words) {
    const Bounds around = box(words);
    const Ray ray = words.ray();
    const auto span = clip(ray, words.interval(), around);
    return span ? fmt::format("hit {} {}", questions::text(span->enter), questions::text(span->exit)) : "miss";
}

std::string contents(const Stage& stage, Words&) {
    const Contents all = contents_of(stage.scene, primitives_of(stage.scene), Real(1e-8));
    return fmt::format("{} {} {}", all.inside.size(), all.outside.size(), text(all.box));
}

std::string resolution(const Stage&, Words& words) {
    const Vec3 extent = words.vector();
    const Cell cells = grid_resolution(extent, static_cast<std::size_t>(words.integer()));
    return fmt::format("{} {} {}", cells[0], cells[1], cells[2]);
}

std::string overlapped_cells(const Stage&, Words& words) {
    const GridSpace grid = space(words);
    const CellRange r = cells_overlapping(grid, box(words));
    return fmt::format("{} {} {} {} {} {}", r.first[0], r.first[1], r.first[2], r.last[0], r.last[1], r.last[2]);
}

std::string walked_cells(const Stage&, Words& words) {
    const GridSpace grid = space(words);
    const Ray ray = words.ray();
    std::string line;
    for (const VisitedCell& v : cells_along(grid, ray, words.interval(), kMostNumbers / 2))
        line += fmt::format("{}{} {}", line.empty() ? "" : " ",
                            v.cell[0] + grid.cells[0] * (v.cell[1] + grid.cells[1] * v.cell[2]),
                            questions::text(v.span.exit));
    return line.empty() ? "miss" : line;
}

std::string mailbox(const Stage&, Words& words) {
    Mailbox box_of_a_ray;
    std::string line;
    for (int n = std::min(words.integer(), static_cast<int>(kMostNumbers)); n-- > 0;)
        line += std::string(line.empty() ? "" : " ") +
                questions::text(box_of_a_ray.was_asked(static_cast<std::uint32_t>(words.integer())));
    return line;
}

std::string octant(const Stage&, Words& words) {
    const Bounds node = box(words);
    return text(octant_of(node, static_cast<unsigned>(words.integer()) & 7));
}

std::string overlapped_octants(const Stage&, Words& words) {
    const Bounds node = box(words);
    return fmt::format("{}", octants_overlapping(node, box(words)));
}

std::string walked_octants(const Stage&, Words& words) {
    const Bounds node = box(words);
    const auto ray = without_zeros(words.ray());
    const Interval range = words.interval();
    if (!ray) return "miss";
    const OctreeRay seen = octree_ray(node, *ray);
    std::array<Octant, 4> octants;
    const int count = octants_along(seen.root, seen.mirror, {range.min, range.max}, octants);
    std::string line;
    for (int i = 0; i < std::clamp(count, 0, 4); ++i) {
        const Octant& o = octants[static_cast<std::size_t>(i)];
        line += fmt::format("{}{} {} {}", i ? " " : "", o.octant, questions::text(o.slabs.enter()),
                            questions::text(o.slabs.exit()));
    }
    return line.empty() ? "miss" : line;
}

// ---- Whole structures -------------------------------------------------------------------------------------------------

/// Null when there is none: unfinished, as a rule.
std::unique_ptr<Intersector> structure_of(const Stage& stage, Partition partition) {
    return partition == Partition::none ? make_exhaustive(stage.scene) : make_structure(stage.scene, partition);
}
const std::string kNoStructure = "error there is no structure";

template <Partition kPartition>
std::string nearest_through(const Stage& stage, Words& words) {
    const auto structure = structure_of(stage, kPartition);
    if (!structure) return kNoStructure;
    const Ray ray = words.ray();
    const auto hit = structure->nearest(ray, words.interval());
    return hit ? fmt::format("hit {} {}", questions::text(hit->t), hit->object) : "miss";
}

template <Partition kPartition>
std::string occluded_through(const Stage& stage, Words& words) {
    const auto structure = structure_of(stage, kPartition);
    if (!structure) return kNoStructure;
    const Ray ray = words.ray();
    return questions::text(structure->occluded(ray, words.interval()));
}

/// While it lives, threads that take interruptions are made to let others go on, wherever they are, two thousand times
/// a second between them: else a busy machine may run one after the other, and what they do to each other never shows.
class Interruptions {
public:
    Interruptions() {
        sigemptyset(&alarm_);
        sigaddset(&alarm_, SIGALRM);
        pthread_sigmask(SIG_BLOCK, &alarm_, nullptr);  // threads that are started now inherit it
        struct sigaction yields {};
        yields.sa_handler = [](int) { sched_yield(); };
        yields.sa_flags = SA_RESTART;
        sigaction(SIGALRM, &yields, nullptr);
        every(kMicroseconds);
    }
    ~Interruptions() { every(0); }
    Interruptions(const Interruptions&) = delete;
    Interruptions& operator=(const Interruptions&) = delete;

    void take() const { pthread_sigmask(SIG_UNBLOCK, &alarm_, nullptr); }

private:
    static constexpr int kMicroseconds = 500;
    static void every(int microseconds) {
        const itimerval interval{{0, microseconds}, {0, microseconds}};
        setitimer(ITIMER_REAL, &interval, nullptr);
    }
    sigset_t alarm_;
};

/// With several threads each first asks the structure so many rays, for each that it compares, twice: nothing else goes
/// on then, so what threads do to each other shows, in answers that differ.
constexpr std::size_t kTogether = 16;

/// Every thread has rays of its own.
template <Partition kPartition>
std::string agreement(const Stage& stage, Words& words) {
    const auto structure = structure_of(stage, kPartition), truth = structure_of(stage, Partition::none);
    if (!structure) return kNoStructure;
    const auto count = static_cast<std::size_t>(words.integer());
    const auto seed = static_cast<std::uint64_t>(words.integer());
    std::vector<Agreement> twice(static_cast<std::size_t>(std::clamp(words.integer(), 1, 8)));
    if (twice.size() > 1) {
        const Interruptions interruptions;
        std::barrier together(static_cast<std::ptrdiff_t>(twice.size()));
        std::vector<std::jthread> threads;
        for (std::size_t i = 0; i < twice.size(); ++i)
            threads.emplace_back([&, i] {
                interruptions.take();
                together.arrive_and_wait();
                twice[i] = compare(stage.scene, *structure, *structure, kTogether * count, seed + i);
            });
    }
    Agreement sum;
    for (std::size_t i = 0; i < twice.size(); ++i) {
        const Agreement r = compare(stage.scene, *structure, *truth, count, seed + i);
        sum.rays += r.rays, sum.hits += r.hits, sum.differences += r.differences + twice[i].differences;
    }
    return fmt::format("{} {} {}", sum.rays, sum.hits, sum.differences);
}

/// Of rays between random points of the box around everything.
template <Partition kPartition>
std::string effort_of(const Stage& stage, Words& words) {
    const auto structure = structure_of(stage, kPartition);
    if (!structure) return kNoStructure;
    const int count = words.integer();
    HardRays rays(stage.scene, static_cast<std::uint64_t>(words.integer()));
    EffortCount counted;
    for (int i = 0; i < count; ++i) structure->nearest(rays.through_the_box(), {0, kInfinity});
    return fmt::format("{:.6g} {:.6g}", static_cast<double>(counted.so_far().tests) / count,
                       static_cast<double>(counted.so_far().nodes) / count);
}

}  // namespace

void add_partitioning(Answerers& answerers) {
    answerers.insert({{"bounds", bounds},
                      {"clip", clipped},
                      {"contents", contents},
                      {"resolution", resolution},
                      {"cells_overlapping", overlapped_cells},
                      {"cells_along", walked_cells},
                      {"mailbox", mailbox},
                      {"octant", octant},
                      {"octants_overlapping", overlapped_octants},
                      {"octants_along", walked_octants},
                      {"nearest_grid", nearest_through<Partition::grid>},
                      {"nearest_octree", nearest_through<Partition::octree>},
                      {"occluded_grid", occluded_through<Partition::grid>},
                      {"occluded_octree", occluded_through<Partition::octree>},
                      {"agreement_grid", agreement<Partition::grid>},
                      {"agreement_octree", agreement<Partition::octree>},
                      {"effort_none", effort_of<Partition::none>},
                      {"effort_grid", effort_of<Partition::grid>},
                      {"effort_octree", effort_of<Partition::octree>},
                      {"partition", [](const Stage& s, Words&) {
                           return fmt::format("{}", static_cast<int>(choose_partition(s.scene)));
                       }}});
}

}  // namespace rays::questions
