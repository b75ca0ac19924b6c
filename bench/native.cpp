// The original's frame rules as a plain loop: the yardstick for the engine's accuracy `arcade`. Everything is examined in every
// frame, as in the original. It shares nothing with the engine but the rules, and must end with the same bits.
//
// stdin:  scenes as numbers in text (see `readScene`), then commands: "check", "time SCENE TIMES", end of file to exit
// stdout: check: one line per run: frames, outcome, minerals, x, y, vx, vy, cos, sin; time: a line with ns of processor time, and frames

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

constexpr double TICK = 1.0 / 60;
constexpr double HALF_WIDTH = 10;
constexpr double HALF_HEIGHT = 16;
constexpr double HALF_DIAGONAL = 18.868;
constexpr double GUN_PULL = 1.3 * 30;
constexpr double REPULSOR_PUSH = 20;
constexpr double ALIEN_PULL = 8;
constexpr double ALIEN_SIGHT = 150;
constexpr double SPEED_LIMIT = 1000;
constexpr int EXPLOSION_FRAMES = 150;

enum Outcome { GOING, LOST, COMPLETED, BURNED };

struct Circle {
  double x, y, r;
};

struct Wind {
  Circle disc;
  double ax, ay;
};

struct Wormhole {
  Circle mouths[2];
};

struct Rock {
  double x, y, vx, vy, ax, ay, r;
};

struct Alien {
  double x, y, vx, vy, ax, ay, moveX, moveY, r;
  bool exploded;
  int chasesUntil;
};

struct Hold {
  int press, release;
};

struct Scene {
  double x, y, vx, vy;
  Circle hole;
  double range;
  bool recoil;
  std::vector<Circle> rocks;  // cold ones, then hot ones
  size_t cold;
  std::vector<Circle> novae, repulsors, aliens, minerals;
  std::vector<Wind> winds;
  std::vector<Wormhole> wormholes;
  int maxFrames;
  std::vector<std::vector<Hold>> runs;
};

struct State {
  int frame;
  Outcome outcome;
  int minerals;
  double x, y, vx, vy, ax, ay, cos, sin;
  std::vector<Rock> rocks;
  std::vector<Alien> aliens;
  std::vector<bool> collected;
  std::vector<int> around;  // for each wormhole the mouth that she is in, or OPEN
};

constexpr int OPEN = -1;

static bool inside(const Circle &c, double x, double y) { return (x - c.x) * (x - c.x) + (y - c.y) * (y - c.y) < c.r * c.r; }

static int mouthAround(const Wormhole &hole, double x, double y) {
  return inside(hole.mouths[0], x, y) ? 0 : inside(hole.mouths[1], x, y) ? 1 : OPEN;
}

static double limited(double v) { return v > SPEED_LIMIT ? SPEED_LIMIT : v < -SPEED_LIMIT ? -SPEED_LIMIT : v; }

static bool touches(const State &s, double cx, double cy, double r) {
  const double dx = cx - s.x;
  const double dy = cy - s.y;
  const double reach = HALF_DIAGONAL + r;
  if (dx > reach || dx < -reach || dy > reach || dy < -reach) return false;
  const double gx = std::abs(dx * s.cos + dy * s.sin) - HALF_WIDTH;
  const double gy = std::abs(dy * s.cos - dx * s.sin) - HALF_HEIGHT;
  if (gx <= 0) return gy < r;
  if (gy <= 0) return gx < r;
  return gx * gx + gy * gy < r * r;
}

static void start(const Scene &scene, State &s) {
  s.frame = 0;
  s.outcome = GOING;
  s.minerals = 0;
  s.x = scene.x;
  s.y = scene.y;
  s.vx = scene.vx;
  s.vy = scene.vy;
  s.ax = s.ay = 0;
  s.cos = 1;
  s.sin = 0;
  s.rocks.clear();
  for (const Circle &c : scene.rocks) s.rocks.push_back({c.x, c.y, 0, 0, 0, 0, c.r});
  s.aliens.clear();
  for (const Circle &c : scene.aliens) s.aliens.push_back({c.x, c.y, 0, 0, 0, 0, 0, 0, c.r, false, 0});
  s.collected.assign(scene.minerals.size(), false);
  s.around.clear();
  for (const Wormhole &hole : scene.wormholes) s.around.push_back(mouthAround(hole, s.x, s.y));
}

static void check(const Scene &scene, State &s) {
  if (touches(s, scene.hole.x, scene.hole.y, scene.hole.r)) s.outcome = COMPLETED;
  for (size_t i = 0; i < scene.novae.size() && s.outcome == GOING; i++) {
    const Circle &c = scene.novae[i];
    if (touches(s, c.x, c.y, c.r)) s.outcome = BURNED;
  }
  for (size_t i = scene.cold; i < s.rocks.size() && s.outcome == GOING; i++) {
    const Rock &c = s.rocks[i];
    if (touches(s, c.x, c.y, c.r)) s.outcome = BURNED;
  }
  // of several minerals touched in one frame all count, and only the last is removed
  int last = -1;
  for (size_t i = 0; i < scene.minerals.size(); i++) {
    const Circle &c = scene.minerals[i];
    if (s.collected[i] || !touches(s, c.x, c.y, c.r)) continue;
    s.minerals++;
    last = static_cast<int>(i);
  }
  if (last >= 0) s.collected[last] = true;
  for (size_t i = 0; i < s.aliens.size() && s.outcome == GOING; i++) {
    const Alien &a = s.aliens[i];
    if (touches(s, a.x, a.y, a.r)) s.outcome = BURNED;
  }
  for (size_t i = 0; i < s.aliens.size(); i++) {
    for (size_t j = i + 1; j < s.aliens.size(); j++) {
      Alien &a = s.aliens[i];
      Alien &b = s.aliens[j];
      if (a.exploded || b.exploded) continue;
      const double dx = a.x - b.x;
      const double dy = a.y - b.y;
      const double reach = a.r + b.r;
      if (dx * dx + dy * dy >= reach * reach) continue;
      a.exploded = b.exploded = true;
      a.chasesUntil = b.chasesUntil = s.frame + EXPLOSION_FRAMES;
    }
  }
}

// moves her through the first open wormhole with a mouth that contains her
static void jump(const Scene &scene, State &s) {
  for (size_t w = 0; w < scene.wormholes.size(); w++) {
    if (s.around[w] != OPEN) s.around[w] = mouthAround(scene.wormholes[w], s.x, s.y);
  }
  for (size_t w = 0; w < scene.wormholes.size(); w++) {
    if (s.around[w] != OPEN) continue;
    const Wormhole &hole = scene.wormholes[w];
    const int from = mouthAround(hole, s.x, s.y);
    if (from == OPEN) continue;
    s.x += hole.mouths[1 - from].x - hole.mouths[from].x;
    s.y += hole.mouths[1 - from].y - hole.mouths[from].y;
    for (size_t other = 0; other < scene.wormholes.size(); other++) {
      s.around[other] = mouthAround(scene.wormholes[other], s.x, s.y);
    }
    s.around[w] = 1 - from;
    return;
  }
}

static void step(const Scene &scene, State &s, bool held) {
  // velocities and displacements; places stay those of the previous frame
  s.vx = limited(s.vx + s.ax * TICK);
  s.vy = limited(s.vy + s.ay * TICK);
  const double moveX = s.vx * TICK;
  const double moveY = s.vy * TICK;
  if (scene.recoil) {
    for (Rock &rock : s.rocks) {
      rock.vx = limited(rock.vx + rock.ax * TICK);
      rock.vy = limited(rock.vy + rock.ay * TICK);
    }
  }
  for (Alien &a : s.aliens) {
    a.vx = limited(a.vx + a.ax * TICK);
    a.vy = limited(a.vy + a.ay * TICK);
    a.moveX = a.vx * TICK;
    a.moveY = a.vy * TICK;
  }

  // the gun
  Rock *nearest = nullptr;
  double best = std::numeric_limits<double>::infinity();
  for (Rock &rock : s.rocks) {
    const double dx = rock.x - s.x;
    const double dy = rock.y - s.y;
    const double d2 = dx * dx + dy * dy;
    if (d2 < best) {
      best = d2;
      nearest = &rock;
    }
  }
  if (best > scene.range * scene.range) s.outcome = LOST;
  s.ax = 0;
  s.ay = 0;
  if (nearest != nullptr && held) {
    const double d = std::sqrt(best);
    s.cos = d > 0 ? (nearest->x - s.x) / d : 1;
    s.sin = d > 0 ? (nearest->y - s.y) / d : 0;
    const double pull = GUN_PULL * (1 - d / scene.range);
    s.ax = pull * s.cos;
    s.ay = pull * s.sin;
    const double recoil = 1 / (2 * nearest->r);
    nearest->ax = -recoil * s.cos;
    nearest->ay = -recoil * s.sin;
  } else if (nearest != nullptr) {
    nearest->ax = 0;
    nearest->ay = 0;
  }

  if (s.outcome == GOING) check(scene, s);

  // aliens chase her
  for (Alien &a : s.aliens) {
    const double dx = s.x - a.x;
    const double dy = s.y - a.y;
    const double d = std::sqrt(dx * dx + dy * dy);
    if (d < ALIEN_SIGHT && !(a.exploded && s.frame >= a.chasesUntil)) {
      a.ax = d > 0 ? ALIEN_PULL * dx / d : ALIEN_PULL;
      a.ay = d > 0 ? ALIEN_PULL * dy / d : 0;
    } else {
      a.vx = a.vy = a.ax = a.ay = 0;
    }
  }

  // fields push her; the first wins
  for (const Circle &field : scene.repulsors) {
    const double dx = s.x - field.x;
    const double dy = s.y - field.y;
    const double d2 = dx * dx + dy * dy;
    if (d2 >= field.r * field.r) continue;
    const double d = std::sqrt(d2);
    s.ax = d > 0 ? REPULSOR_PUSH * dx / d : REPULSOR_PUSH;
    s.ay = d > 0 ? REPULSOR_PUSH * dy / d : 0;
    break;
  }

  for (const Wind &wind : scene.winds) {
    if (!inside(wind.disc, s.x, s.y)) continue;
    s.ax += wind.ax;
    s.ay += wind.ay;
  }
  jump(scene, s);

  if (s.outcome == BURNED) s.vx = s.vy = 0;
  s.x += moveX;
  s.y += moveY;
  if (scene.recoil) {
    for (Rock &rock : s.rocks) {
      rock.x += rock.vx * TICK;
      rock.y += rock.vy * TICK;
    }
  }
  for (Alien &a : s.aliens) {
    a.x += a.moveX;
    a.y += a.moveY;
  }
  s.frame++;
}

static void play(const Scene &scene, const std::vector<Hold> &holds, State &s) {
  start(scene, s);
  size_t next = 0;
  while (s.frame < scene.maxFrames && s.outcome == GOING) {
    while (next < holds.size() && s.frame >= holds[next].release) next++;
    step(scene, s, next < holds.size() && s.frame >= holds[next].press);
  }
}

static double readNumber() {
  std::string word;
  if (!(std::cin >> word)) {
    std::fprintf(stderr, "expected a number on stdin, found its end\n");
    std::exit(2);
  }
  return std::strtod(word.c_str(), nullptr);
}

static int readCount() { return static_cast<int>(readNumber()); }

static Circle readCircle() {
  Circle c;
  c.x = readNumber();
  c.y = readNumber();
  c.r = readNumber();
  return c;
}

static std::vector<Circle> readCircles() {
  std::vector<Circle> circles(readCount());
  for (Circle &c : circles) c = readCircle();
  return circles;
}

// Reads: x y vx vy; black hole: x y r; range; recoil 0 or 1; lists of circles (count, then x y r of each): cold asteroids, hot
// ones, novae, repulsors, aliens, minerals; winds (count, then x y r ax ay of each); wormholes (count, then x y r of both mouths);
// the largest number of frames; the number of runs; for each run the number of holds, then press and release of each.
static Scene readScene() {
  Scene scene;
  scene.x = readNumber();
  scene.y = readNumber();
  scene.vx = readNumber();
  scene.vy = readNumber();
  scene.hole.x = readNumber();
  scene.hole.y = readNumber();
  scene.hole.r = readNumber();
  scene.range = readNumber();
  scene.recoil = readNumber() != 0;
  scene.rocks = readCircles();
  scene.cold = scene.rocks.size();
  for (const Circle &hot : readCircles()) scene.rocks.push_back(hot);
  scene.novae = readCircles();
  scene.repulsors = readCircles();
  scene.aliens = readCircles();
  scene.minerals = readCircles();
  scene.winds.resize(readCount());
  for (Wind &wind : scene.winds) {
    wind.disc = readCircle();
    wind.ax = readNumber();
    wind.ay = readNumber();
  }
  scene.wormholes.resize(readCount());
  for (Wormhole &hole : scene.wormholes) {
    for (Circle &mouth : hole.mouths) mouth = readCircle();
  }
  scene.maxFrames = readCount();
  scene.runs.resize(readCount());
  for (std::vector<Hold> &holds : scene.runs) {
    holds.resize(readCount());
    for (Hold &hold : holds) {
      hold.press = readCount();
      hold.release = readCount();
    }
  }
  return scene;
}

int main() {
  std::vector<Scene> scenes(readCount());
  for (Scene &scene : scenes) scene = readScene();
  State s;
  double sink = 0;
  std::string command;
  while (std::cin >> command) {
    if (command == "check") {
      for (const Scene &scene : scenes) {
        for (const std::vector<Hold> &holds : scene.runs) {
          play(scene, holds, s);
          std::printf("%d %d %d %.17g %.17g %.17g %.17g %.17g %.17g\n", s.frame, s.outcome, s.minerals, s.x, s.y, s.vx, s.vy,
                      s.cos, s.sin);
        }
      }
    } else {
      const Scene &scene = scenes.at(readCount());
      const int times = readCount();
      long frames = 0;
      const std::clock_t begin = std::clock();
      for (int k = 0; k < times; k++) {
        for (const std::vector<Hold> &holds : scene.runs) {
          play(scene, holds, s);
          sink += s.x + s.y;
          frames += s.frame;
        }
      }
      const double spent = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
      std::printf("%.0f %ld\n", 1e9 * spent, frames);
    }
    std::fflush(stdout);
  }
  std::fprintf(stderr, "%g\n", sink);
}
