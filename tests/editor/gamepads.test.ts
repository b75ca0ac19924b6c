import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { followGamepads } from '../../editor/core/commands/index.ts';

/** Gamepads as a browser shows them, and a page whose frames the test draws. */
function stage() {
  const pads: (Partial<Gamepad> | null)[] = [];
  const frames = new Map<number, () => void>();
  const listeners = new Map<string, () => void>();
  let last = 0;
  const page = {
    navigator: { getGamepads: () => pads as Gamepad[] },
    addEventListener: (type: string, listener: () => void) => void listeners.set(type, listener),
    removeEventListener: (type: string) => void listeners.delete(type),
    requestAnimationFrame(call: () => void) {
      frames.set(++last, call);
      return last;
    },
    cancelAnimationFrame: (id: number) => void frames.delete(id),
  };
  return {
    page: page as unknown as Window,
    pads,
    frames,
    listeners,
    draw() {
      const due = [...frames.values()];
      frames.clear();
      for (const call of due) call();
    },
  };
}

const padOf = (index: number, down: readonly number[], axes: readonly number[] = [0, 0]): Partial<Gamepad> => ({
  index,
  axes,
  buttons: Array.from({ length: 16 }, (_, i) => ({ pressed: down.includes(i), touched: false, value: down.includes(i) ? 1 : 0 })),
});

describe('gamepads', () => {
  it('are not looked at while there are none', () => {
    const { page, frames, listeners, pads, draw } = stage();
    const stop = followGamepads(page, () => {});
    draw();
    expect(frames.size).toBe(0);
    pads.push(padOf(0, []));
    listeners.get('gamepadconnected')?.();
    draw();
    expect(frames.size).toBe(1);
    stop();
    expect([frames.size, listeners.size]).toEqual([0, 0]);
  });

  it('tell every press and every release once, whatever is pressed, plugged in or pulled out', () => {
    const pad = fc.oneof(
      fc.constant(null),
      fc.record({ down: fc.uniqueArray(fc.integer({ min: 0, max: 15 }), { maxLength: 4 }), x: fc.double({ min: -1, max: 1 }) }),
    );
    fc.assert(
      fc.property(fc.array(fc.tuple(pad, pad), { maxLength: 12 }), (moments) => {
        const { page, pads, draw, frames, listeners } = stage();
        const held = new Set<string>();
        const stop = followGamepads(page, ({ source, isDown }) => {
          expect(held.has(source)).toBe(!isDown);
          if (isDown) held.add(source);
          else held.delete(source);
        });
        for (const moment of moments) {
          pads.splice(0, pads.length, ...moment.map((one, index) => one && padOf(index, one.down, [one.x, 0])));
          if (frames.size === 0) listeners.get('gamepadconnected')?.();
          draw();
          const wanted = moment.flatMap((one, index) => {
            if (one === null) return [];
            const tilted = [...(one.x < -0.6 ? [14] : []), ...(one.x > 0.6 ? [15] : [])];
            return [...new Set([...one.down, ...tilted])].map((button) => `gamepad ${index} button ${button}`);
          });
          expect([...held].sort()).toEqual(wanted.sort());
        }
        stop();
        expect(held.size).toBe(0);
      }),
    );
  });

  it('hold the gun with face buttons, shoulders and triggers, and name the others', () => {
    const { page, pads, draw } = stage();
    const told: (string | null | boolean)[][] = [];
    pads.push(padOf(0, [0, 7, 8, 9, 12], [0, 0.9]));
    followGamepads(page, ({ name, holdsGun }) => told.push([name, holdsGun]));
    draw();
    draw();
    expect(told).toEqual([
      ['A', true],
      [null, true],
      ['Select', false],
      ['Start', false],
      ['Up', false],
      ['Down', false],
    ]);
  });

  it('are none where the browser refuses to show them', () => {
    const { page, draw, frames } = stage();
    const refusing = Object.assign(page, {
      navigator: {
        getGamepads() {
          throw new DOMException('refused', 'SecurityError');
        },
      },
    });
    followGamepads(refusing, () => expect.unreachable());
    draw();
    expect(frames.size).toBe(0);
  });
});
