import { afterAll, beforeEach, describe, expect, it, vi } from 'vitest';
import { compile, simulate } from '../../engine/index.ts';
import { createRunner, DEFAULT_SKIN, type Runner, type RunnerOptions } from '../../phaser/index.ts';
import { readLevel } from '../../schema/index.ts';
import { pack, shipped } from '../levels/shipped-pack.ts';
import { FakeObject, FakePage, type FakeScene, fakePointer, fakeScene } from './fake-phaser.ts';

const MS = 1000 / 60;

let page = new FakePage();
let fake: FakeScene = fakeScene(page);

beforeEach(() => {
  page = new FakePage();
  page.install();
  fake = fakeScene(page);
});
afterAll(() => vi.unstubAllGlobals());

const { level } = shipped('first-swing');

const start = (options: RunnerOptions = {}, of = level): Runner => {
  const runner = createRunner(fake.scene, of, options);
  fake.frame(0);
  return runner;
};

let now = 0;
/** Frames of a tick each. */
const frames = (count: number) => {
  for (let i = 0; i < count; i++) {
    now += MS;
    fake.frame(now);
  }
};
beforeEach(() => {
  now = 0;
});

/** A level in which she is lost after a second if she does nothing. */
const drifting = () => {
  const reading = readLevel(
    '{"version":1,"name":"away","astronaut":{"x":0,"y":0,"vx":300},"blackHole":{"x":-400,"y":0},' +
      '"asteroids":[{"x":0,"y":60,"radius":16}]}',
  );
  if (!reading.ok) throw new Error('not valid');
  return reading.level;
};

describe('the time of a runner', () => {
  it.each(pack.map(({ slug, level: of }) => [slug, of] as const))('%s: its own run ends as simulate says', (_, of) => {
    const [{ holds }] = of.runs;
    const run = simulate(compile(of, 'precise'), holds);
    const runner = start({ replay: holds, restartAfter: null }, of);
    frames(Math.ceil(60 * run.time) + 2);
    expect(runner.player.ending).toMatchObject({ outcome: run.outcome, tick: run.tick, time: run.time });
    expect(runner.player.events).toEqual(run.events);
  });

  it('is that of the clock, whatever Phaser makes of it', () => {
    const runner = start();
    for (let i = 1; i <= 120; i++) fake.frame(i * 7, i % 3 === 0 ? 0 : 16.66);
    expect(runner.player.tick).toBe(Math.floor((120 * 7) / MS));
  });

  it('stands still in a pause, on a hidden page, and while the scene sleeps', () => {
    const runner = start();
    frames(10);
    runner.pause();
    frames(50);
    expect([runner.paused, runner.player.tick]).toEqual([true, 10]);
    runner.resume();
    frames(1);
    expect([runner.paused, runner.player.tick]).toEqual([false, 11]);
    page.hide(true);
    frames(50);
    expect([runner.paused, runner.player.tick]).toEqual([false, 11]);
    page.hide(false);
    now += 90_000;
    frames(3);
    expect(runner.player.tick).toBe(13);
    fake.events.emit('sleep');
    now += 90_000;
    fake.events.emit('wake');
    frames(3);
    expect(runner.player.tick).toBe(15);
    fake.events.emit('pause');
    now += 90_000;
    fake.events.emit('resume');
    frames(3);
    expect(runner.player.tick).toBe(17);
  });

  it('does not let decorations jump after a stall', () => {
    const times: number[] = [];
    start({ skin: { trail: (stage) => ({ objects: [], update: () => times.push(stage.time) }) } });
    frames(1);
    now += 60_000;
    frames(1);
    const [before, after] = times.slice(-2);
    expect(after - before).toBeCloseTo(0.1, 9);
  });
});

describe('the button of a runner', () => {
  const press = (pointer: ReturnType<typeof fakePointer>, over: unknown[] = []) => fake.input.emit('pointerdown', pointer, over);
  const lift = (pointer: ReturnType<typeof fakePointer>) => Object.assign(pointer, { isDown: false, primaryDown: false });

  it('is a mouse, a finger, a key or a gamepad, and goes up with the last of them', () => {
    const runner = start();
    const [mouse, finger] = [fakePointer(0), fakePointer(1, { touch: true })];
    const button = { index: 0, pressed: true };
    const pad = { index: 0, connected: true };
    press(mouse);
    press(finger);
    page.key('keydown', 'Space');
    page.key('keydown', 'ArrowUp');
    fake.gamepad.emit('down', pad, button);
    frames(2);
    const releases = [
      () => fake.input.emit('pointerup', lift(mouse)),
      () => fake.input.emit('pointerupoutside', lift(finger)),
      () => page.key('keyup', 'Space'),
      () => page.key('keyup', 'ArrowUp'),
    ];
    for (const release of releases) {
      release();
      frames(1);
      expect(runner.player.held).toBe(true);
    }
    button.pressed = false;
    fake.gamepad.emit('up', pad, button);
    frames(1);
    expect(runner.player.held).toBe(false);
    expect(runner.player.holds).toEqual([[0, 6]]);
  });

  it('counts a press and a release between two frames', () => {
    const runner = start();
    const mouse = fakePointer(0);
    press(mouse);
    fake.input.emit('pointerup', lift(mouse));
    frames(5);
    expect(runner.player.holds).toEqual([[0, 1]]);
  });

  it.each([
    ['a pointer goes up where Phaser does not say so', (mouse: ReturnType<typeof fakePointer>) => void lift(mouse)],
    ['the page loses the focus', () => page.window.dispatchEvent(new Event('blur'))],
    ['the page is hidden', () => [page.hide(true), page.hide(false)]],
    ['the scene is paused', () => fake.events.emit('pause')],
    ['the scene sleeps', () => fake.events.emit('sleep')],
  ])('goes up when %s', (_, happens) => {
    const runner = start();
    const mouse = fakePointer(0);
    press(mouse);
    frames(3);
    expect(runner.player.held).toBe(true);
    happens(mouse);
    frames(2);
    expect(runner.player.held).toBe(false);
  });

  it('goes up with a gamepad that is gone', () => {
    const runner = start();
    for (const gone of [
      (pad: object) => fake.gamepad.emit('disconnected', pad),
      (pad: object) => Object.assign(pad, { connected: false }),
    ]) {
      const pad = { index: 1, connected: true };
      fake.gamepad.emit('down', pad, { index: 7, pressed: true });
      frames(2);
      expect(runner.player.held).toBe(true);
      gone(pad);
      frames(1);
      expect(runner.player.held).toBe(false);
    }
  });

  it('ignores buttons of the game, other mouse buttons, other keys, key repeat, keys for the page, and menu buttons', () => {
    const runner = start({ area: () => ({ x: 0, y: 100, width: 800, height: 500 }) });
    press(fakePointer(0), [{}]);
    press({ ...fakePointer(1), primaryDown: false });
    press(fakePointer(2, { y: 20 }));
    press(fakePointer(3, { x: 900 }));
    page.key('keydown', 'KeyR');
    page.key('keydown', 'Space', { repeat: true });
    for (const key of ['ctrlKey', 'altKey', 'metaKey']) page.key('keydown', 'Space', { [key]: true });
    const field = { closest: (selector: string) => (selector.includes('textarea') ? {} : null) };
    const event = new Event('keydown');
    Object.defineProperty(event, 'target', { value: field });
    Object.assign(event, { code: 'Space', repeat: false });
    page.window.dispatchEvent(event);
    fake.gamepad.emit('down', { index: 0, connected: true }, { index: 9, pressed: true });
    frames(3);
    expect(runner.player.holds).toEqual([]);
  });

  it('goes up when Command does, while which macOS reports no release', () => {
    const runner = start();
    page.key('keydown', 'Space');
    frames(2);
    page.key('keyup', 'MetaLeft', { key: 'Meta' });
    frames(1);
    expect(runner.player.holds).toEqual([[0, 2]]);
  });

  it.each([
    ['its scene is not active', () => Object.assign(fake.scene.sys, { isActive: () => false })],
    ['the input of its scene is off', () => Object.assign(fake.scene.input, { enabled: false })],
  ])('ignores keys and gamepads while %s', (_, happens) => {
    const runner = start();
    happens();
    page.key('keydown', 'Space');
    fake.gamepad.emit('down', { index: 0, connected: true }, { index: 0, pressed: true });
    frames(2);
    expect(runner.player.holds).toEqual([]);
  });

  it('keeps the page from scrolling, for its own keys only', () => {
    start();
    expect(page.key('keydown', 'Space').defaultPrevented).toBe(true);
    expect(page.key('keydown', 'Space', { repeat: true }).defaultPrevented).toBe(true);
    expect(page.key('keydown', 'KeyR').defaultPrevented).toBe(false);
  });

  it('can be other keys, or none at all', () => {
    const runner = start({ input: { keys: ['KeyX'], pointer: false, gamepad: false } });
    press(fakePointer(0));
    page.key('keydown', 'Space');
    frames(1);
    expect(runner.player.held).toBe(false);
    page.key('keydown', 'KeyX');
    frames(1);
    expect(runner.player.held).toBe(true);
    runner.destroy();
    const silent = start({ input: false });
    press(fakePointer(0));
    page.key('keydown', 'Space');
    frames(1);
    expect(silent.player.held).toBe(false);
  });

  it('is where it is after a pause and after a restart', () => {
    const runner = start();
    page.key('keydown', 'Space');
    frames(2);
    runner.pause();
    page.key('keyup', 'Space');
    runner.resume();
    frames(1);
    expect(runner.player.held).toBe(false);
    page.key('keydown', 'Space');
    runner.restart();
    frames(1);
    expect(runner.player.holds).toEqual([[0, 1]]);
  });
});

describe('a death', () => {
  it.each([
    [0, 1],
    [500, 30],
  ])('is followed by another attempt after %i ms', (restartAfter, count) => {
    const onRestart = vi.fn();
    const runner = start({ restartAfter, onRestart }, drifting());
    while (runner.player.ending === null) frames(1);
    expect(runner.player.ending.outcome).toBe('lost');
    frames(count - 1);
    expect(onRestart).toHaveBeenCalledTimes(0);
    frames(1);
    expect(onRestart).toHaveBeenCalledTimes(1);
    expect([runner.player.tick, runner.player.ending]).toEqual([0, null]);
  });

  it('is followed at once when the button is pressed, but not by the press that came too late', () => {
    const runner = start({ restartAfter: 10_000 }, drifting());
    while (runner.player.ending === null) frames(1);
    page.key('keydown', 'Space');
    page.key('keyup', 'Space');
    frames(1);
    expect(runner.player.ending).not.toBeNull();
    frames(20);
    page.key('keydown', 'Space');
    frames(1);
    expect(runner.player.holds).toEqual([[0, 1]]);
  });

  it('is not followed by a second finger while the first is still down', () => {
    const runner = start({ restartAfter: 10_000 }, drifting());
    page.key('keydown', 'ArrowUp');
    while (runner.player.ending === null) frames(1);
    frames(20);
    page.key('keydown', 'Space');
    frames(1);
    expect(runner.player.ending).not.toBeNull();
  });

  it('is the end without restartAfter, and so is completion', () => {
    const runner = start({ restartAfter: null }, drifting());
    frames(400);
    page.key('keydown', 'Space');
    frames(1);
    expect(runner.player.ending?.outcome).toBe('lost');
    page.key('keyup', 'Space');
    runner.load(level, { replay: level.runs[0].holds, restartAfter: 0 });
    frames(1200);
    expect(runner.player.ending?.outcome).toBe('completed');
    // what the attempt began with is not for the next level
    runner.load(level);
    page.key('keydown', 'Space');
    frames(3);
    expect(runner.player.holds).toEqual([[0, 3]]);
  });
});

describe('what a runner adds', () => {
  it('is gone with it, with its scene, and after a hundred of them', () => {
    const before = [fake.listeners(), fake.alive.size];
    const ends = [
      (runner: Runner) => runner.destroy(),
      () => fake.events.emit('shutdown'),
      () => fake.events.emit('destroy'),
      (runner: Runner) => [runner.destroy(), fake.events.emit('shutdown'), runner.destroy()],
    ];
    for (let i = 0; i < 100; i++) {
      const runner = start({ ghosts: [{ name: 'best', holds: [] }] }, pack[i % pack.length].level);
      expect(fake.alive.size).toBeGreaterThan(100);
      expect(fake.listeners()).toBeGreaterThan(before[0]);
      frames(2);
      runner.load(level);
      frames(2);
      ends[i % ends.length](runner);
      expect([fake.listeners(), fake.alive.size]).toEqual(before);
    }
    // nothing listens any more
    frames(3);
    expect(fake.alive.size).toBe(before[1]);
  });

  it('is apart from another runner of the scene', () => {
    const one = start({ input: { keys: ['KeyA'] } });
    const other = start({ input: { keys: ['KeyB'] }, skin: { background: () => null } }, drifting());
    page.key('keydown', 'KeyA');
    frames(5);
    expect([one.player.holds, other.player.holds]).toEqual([[[0, 5]], []]);
    const objects = fake.alive.size;
    other.destroy();
    expect(fake.alive.size).toBeLessThan(objects);
    frames(5);
    expect([one.player.tick, other.player.tick]).toEqual([10, 5]);
  });

  it('is told nothing more once an event has ended it', () => {
    const told: string[] = [];
    const runner: Runner = start({
      skin: {
        beam: () => ({ objects: [], onEvent: () => runner.destroy() }),
        effects: () => ({ objects: [], onEvent: () => told.push('effects') }),
      },
    });
    runner.player.press();
    frames(3);
    expect([runner.destroyed, told]).toEqual([true, []]);
  });

  it('may be ended or changed by its own callbacks', () => {
    const runner: Runner = start({ onEnd: () => runner.load(level), restartAfter: null }, drifting());
    frames(300);
    expect(runner.player.level).toBe(level);
    const gone: Runner = start({ onEnd: () => gone.destroy() }, drifting());
    frames(300);
    runner.destroy();
    expect(fake.alive.size).toBe(0);
    expect(() => gone.load(level)).toThrow(/destroyed/);
  });
});

describe('a skin', () => {
  it('replaces what it names, and follows the play', () => {
    const log: string[] = [];
    const figure = (name: string) => ({
      objects: [],
      onEvent: ({ event }: { event: { type: string } }) => log.push(`${name} ${event.type}`),
      onRestart: () => log.push(`${name} again`),
      onDestroy: () => log.push(`${name} gone`),
    });
    const runner = start({
      skin: { mineral: (_, __, i) => (i === 0 ? figure('first') : null), effects: () => figure('effects') },
    });
    runner.player.press();
    frames(2);
    runner.restart();
    // the game may restart the player itself
    frames(2);
    runner.player.restart();
    frames(1);
    runner.destroy();
    expect(log).toEqual([
      ...['first press', 'effects press', 'first target', 'effects target'],
      ...['first again', 'effects again', 'first again', 'effects again', 'first gone', 'effects gone'],
    ]);
  });

  it('shows the default for the rest: she is where the player is, minerals vanish, ghosts come with an attempt', () => {
    const runner = start({ restartAfter: null });
    const named = (texture: string): FakeObject[] => [...fake.alive].filter((one) => one.texture === `gravity-quest:${texture}`);
    const [her] = named('astronaut');
    frames(40);
    const pose = new Float64Array(6);
    runner.player.readPose(pose);
    expect([her.x, her.y]).toEqual([pose[0], pose[1]]);
    expect(named('mineral')).toHaveLength(level.minerals.length);
    runner.player.restart({ replay: level.runs[0].holds, ghosts: [{ name: 'best', holds: [] }] });
    frames(1200);
    expect(runner.player.ending?.outcome).toBe('completed');
    const visible = named('mineral').filter((one) => one.visible).length;
    expect(visible).toBe(level.minerals.length - runner.player.mineralCount);
    expect(named('astronaut-b9a6ff')).toHaveLength(1);
    runner.player.restart({ ghosts: [] });
    frames(1);
    expect(named('astronaut-b9a6ff')).toHaveLength(0);
    expect(named('mineral').every((one) => one.visible)).toBe(true);
  });

  it('is drawn in the order of depths, ghosts that come later too', () => {
    const runner = start();
    const lists = () => [...fake.alive].map(({ children }) => children).filter(({ length }) => length > 1);
    const expectOrder = () => {
      for (const depths of lists().map((list) => list.map(({ depth }) => depth)))
        expect(depths).toEqual(depths.toSorted((a, b) => a - b));
    };
    const before = lists().flat().length;
    expectOrder();
    runner.player.restart({ ghosts: [{ name: 'best', holds: [] }] });
    frames(1);
    expect(lists().flat()).toHaveLength(before + 2);
    expectOrder();
  });

  it('stays on the canvas, unless the camera of the scene shows the level', () => {
    for (const [camera, factor] of [
      ['fit', 0],
      ['follow', 0],
      ['none', 1],
    ] as const) {
      const runner = start({ camera, depth: 31 });
      expect([...fake.alive].find(({ depth }) => depth === 31)?.scrollFactor).toBe(factor);
      runner.destroy();
    }
  });

  it('leaves nothing behind when it throws, and the level that was played stays', () => {
    const broken = { ...DEFAULT_SKIN, nova: () => expect.unreachable('broken skin') };
    expect(() => start({ skin: broken }, shipped('nova-lane').level)).toThrow('broken skin');
    expect([fake.alive.size, fake.listeners()]).toEqual([0, 0]);
    const runner = start();
    const objects = fake.alive.size;
    expect(() => runner.load(shipped('nova-lane').level, { skin: broken })).toThrow('broken skin');
    expect(() => runner.load({} as never)).toThrow(/Runner.load: expected a level/);
    expect([fake.alive.size, runner.player.level]).toEqual([objects, level]);
    frames(5);
    expect(runner.player.tick).toBe(5);
  });
});

describe('the view', () => {
  const corners = ({ view }: Runner, x: number, y: number) => [
    view.left + view.width / 2 + view.zoom * (x - view.x),
    view.top + view.height / 2 + view.zoom * (y - view.y),
  ];

  it.each([
    [1280, 720],
    [390, 844],
    [844, 390],
    [3840, 2160],
  ])('fits all of the level into %i x %i, and into an area of it', (width, height) => {
    for (const { level: of } of pack) {
      const area = { x: 0, y: 60, width, height: height - 60 };
      Object.assign(fake.scene.cameras.main, { width, height });
      const runner = start({ area: () => area }, of);
      for (const { x, y, radius } of [...of.asteroids, ...of.novae, ...of.minerals, of.blackHole]) {
        for (const side of [-1, 1]) {
          const [left, top] = corners(runner, x + side * radius, y + side * radius);
          expect(left >= 0 && left <= width && top >= 60 && top <= height, `${of.name}: ${left}, ${top}`).toBe(true);
        }
      }
      runner.destroy();
    }
  });

  it.each([300, -300])(
    'follow: she is within a third of the view from its middle, also outside of the level, at %i px/s',
    (vx) => {
      const away = drifting();
      const of = { ...away, astronaut: { ...away.astronaut, vx }, blackHole: { ...away.blackHole, x: vx > 0 ? -400 : 400 } };
      const runner = start({ camera: 'follow', restartAfter: null }, of);
      frames(45);
      // another size shows at once what the view moves to
      Object.assign(fake.scene.cameras.main, { width: 500, height: 500 });
      frames(1);
      const { view, player } = runner;
      expect(Math.abs(player.state[0])).toBeGreaterThan(200);
      expect(Math.abs(player.state[0] - view.x)).toBeLessThanOrEqual(view.width / view.zoom / 3 + 6);
    },
  );

  it.each(['fit', 'follow'] as const)('%s: she stays visible, also after the canvas has changed its size', (camera) => {
    const runner = start({ camera, restartAfter: null }, drifting());
    const { main } = fake.scene.cameras;
    const pose = new Float64Array(6);
    for (let i = 0; i < 70; i++) {
      if (i === 30) Object.assign(main, { width: 390, height: 844 });
      frames(1);
      runner.player.readPose(pose);
      const [x, y] = corners(runner, pose[0], pose[1]);
      expect(x >= 0 && x <= main.width && y >= 0 && y <= main.height).toBe(true);
    }
  });

  it('an area is a part of the canvas, also while the camera zooms', () => {
    Object.assign(fake.scene.cameras.main, { zoom: 2 });
    const runner = start({ area: () => ({ x: 0, y: 200, width: 300, height: 400 }) });
    for (const { x, y, radius } of [...level.asteroids, ...level.minerals, level.blackHole]) {
      for (const side of [-1, 1]) {
        // the camera zooms around its middle
        const [left, top] = corners(runner, x + side * radius, y + side * radius);
        const [onX, onY] = [400 + 2 * (left - 400), 300 + 2 * (top - 300)];
        expect(onX >= 0 && onX <= 300 && onY >= 200 && onY <= 600, `${onX}, ${onY}`).toBe(true);
      }
    }
    for (const [x, y, held] of [
      [290, 590, true],
      [290, 190, false],
      [310, 590, false],
    ] as const) {
      const pointer = fakePointer(0, { x, y });
      fake.input.emit('pointerdown', pointer, []);
      frames(1);
      expect([x, y, runner.player.held]).toEqual([x, y, held]);
      Object.assign(pointer, { isDown: false, primaryDown: false });
      frames(1);
    }
  });

  it('none: a px of the level is a px of the scene', () => {
    const runner = start({ camera: 'none' });
    frames(3);
    expect(corners(runner, 12, 34)).toEqual([12, 34]);
  });

  it('none: also while the camera of the scene scrolls and zooms, and the background follows it', () => {
    const floor = new FakeObject(new Set());
    const runner = start({ camera: 'none', skin: { background: () => ({ objects: [floor as never] }) } });
    const space = [...fake.alive].find(({ children }) => children.includes(floor));
    Object.assign(fake.scene.cameras.main, { zoom: 2, scrollX: 500, scrollY: -100 });
    frames(1);
    expect(corners(runner, 12, 34)).toEqual([12, 34]);
    // the camera shows 400 x 300 px of the scene around its middle
    expect(runner.view).toMatchObject({ left: 700, top: 50, width: 400, height: 300, x: 900, y: 200 });
    expect(space).toMatchObject({ x: 700, y: 50 });
  });
});

describe('bad input', () => {
  const reading = readLevel('{"version":1,"name":"x"}');
  it.each([
    ['no scene', undefined, level, /expected a Phaser scene, found undefined.*3\.90 to 4\.x.*create\(\)/],
    ['a state of Phaser 2', { game: { state: {}, stage: {} } }, level, /found a state of Phaser 2/],
    ['another object', {}, level, /found an object without `sys`/],
    ['a scene before its start', { sys: {} }, level, /has not started/],
    ['a scene that lacks something', { sys: { events: {}, displayList: {} } }, level, /without sys\.events\.on, .*add\.image/],
    ['no level', null, undefined, /expected a level, found undefined.*readLevel/],
    ['a text', null, '{}', /found a string/],
    ['a list', null, [], /found an array/],
    ['the content of a file', null, shipped('first-swing').file, /content of a level file.*it lacks (range|recoil|asteroids)/],
    ['a reading', null, readLevel(shipped('first-swing').text), /pass its `level`/],
    ['a failed reading', null, reading, /not valid \(.+\)/],
    ['a level without a list of runs', null, { ...level, runs: undefined }, /not complete \(it lacks runs\)/],
    ['a part of a level', null, { ...level, asteroids: undefined }, /not complete \(it lacks asteroids\)/],
  ])('%s is refused by name', (_, scene, of, message) => {
    expect(() => createRunner((scene === null ? fake.scene : scene) as never, of as never)).toThrow(message);
    expect([fake.alive.size, fake.listeners()]).toEqual([0, 0]);
  });

  it('a page with another major is named', () => {
    for (const version of ['2.20.2', '3.60.0', '5.0.0']) {
      vi.stubGlobal('Phaser', { VERSION: version });
      expect(() => createRunner(fake.scene, level)).toThrow(
        new RegExp(`This page has Phaser ${version}\\. Phaser 3\\.90 to 4\\.x`),
      );
    }
    vi.stubGlobal('Phaser', { VERSION: '4.2.1' });
    createRunner(fake.scene, level).destroy();
    vi.stubGlobal('Phaser', undefined);
  });

  it('a level without a run is played', () => {
    const runner = start({}, { ...level, runs: [] });
    frames(10);
    expect(runner.player.tick).toBe(10);
  });
});
