import { describe, expect, it } from 'vitest';
import { compile, type RunEvent, STATE_SIZE, simulate, TICK } from '../../engine/index.ts';
import { declareMissing } from '../missing.ts';
import { importedLevels } from './imported-levels.ts';
import { arcadeRecordings, hasTruth, NO_TRUTH, type RecordedRow } from './recordings.ts';

/** How far a place (px) and a velocity (px/s) may be from the recording's. */
const TOLERANCE = 0.01;
/** The original's cos(atan2(y, x)) differs from a unit vector in the last bits; an angle agrees far better than this, radians. */
const ANGLE_TOLERANCE = 1e-6;

const upTo = <T extends RunEvent['type']>(events: readonly RunEvent[], type: T, frame: number) =>
  events.filter((e): e is Extract<RunEvent, { type: T }> => e.type === type && e.time <= (frame + 0.5) * TICK);

const turn = (a: number, b: number) => Math.abs(a - b - 2 * Math.PI * Math.round((a - b) / (2 * Math.PI)));

if (!hasTruth) {
  declareMissing('arcade against the original', NO_TRUTH);
} else {
  const recordings = arcadeRecordings();
  const levels = importedLevels();

  it('there are recordings to compare with', () => {
    expect(recordings.length).toBeGreaterThan(0);
    for (const { runs } of recordings) expect(runs.length).toBeGreaterThan(0);
  });

  describe.each(recordings)('arcade against the original: level $level', ({ level: number, runs }) => {
    const level = levels.get(number);
    if (level === undefined) throw new Error(`the recordings have a level ${number} that was not imported`);
    const scene = compile(level, 'arcade');

    it.each(runs)('run $name: $outcome at frame $frame', (recorded) => {
      const run = simulate(scene, recorded.holds, { maxTime: 60 });
      expect({ outcome: run.outcome, frame: run.tick, minerals: run.minerals.length, with: run.with?.kind ?? null }).toEqual({
        outcome: recorded.outcome,
        frame: recorded.frame,
        minerals: recorded.minerals,
        with: recorded.outcome === 'completed' ? 'blackHole' : recorded.with,
      });

      const state = new Float64Array(STATE_SIZE);
      const aliens = new Float64Array(3 * level.aliens.length);
      const heldIn = (frame: number) => recorded.holds.some(([press, release]) => press <= frame && frame < release);
      const differences: string[] = [];
      const compare = (row: RecordedRow, what: string, found: number, wanted: number, tolerance = 0) => {
        if (!(Math.abs(found - wanted) <= tolerance)) differences.push(`frame ${row[0]}: ${what} ${found}, recorded ${wanted}`);
      };
      for (const row of recorded.rows) {
        const [frame, x, y, vx, vy, angle, nearest, minerals, alienRows] = row;
        run.trajectory.at(frame * TICK, state);
        compare(row, 'x', state[0], x, TOLERANCE);
        compare(row, 'y', state[1], y, TOLERANCE);
        compare(row, 'vx', state[2], vx, TOLERANCE);
        compare(row, 'vy', state[3], vy, TOLERANCE);
        compare(row, 'turned by', turn(Math.atan2(state[5], state[4]), angle), 0, ANGLE_TOLERANCE);
        compare(row, 'minerals', upTo(run.events, 'mineral', frame).length, minerals);
        if (heldIn(frame)) compare(row, 'target', upTo(run.events, 'target', frame).at(-1)?.index ?? -1, nearest);
        if (alienRows !== undefined) run.trajectory.aliensAt(frame * TICK, aliens);
        for (const [i, [alienX, alienY, alive]] of (alienRows ?? []).entries()) {
          compare(row, `x of alien ${i}`, aliens[3 * i], alienX, TOLERANCE);
          compare(row, `y of alien ${i}`, aliens[3 * i + 1], alienY, TOLERANCE);
          // the recordings call an alien dead from the frame in which it explodes, though it goes on chasing
          compare(row, `alive of alien ${i}`, aliens[3 * i + 2], Number(alive));
        }
      }
      expect(recorded.rows.at(-1)?.[0]).toBeLessThanOrEqual(Math.round(run.trajectory.duration / TICK));
      expect(differences.slice(0, 10)).toEqual([]);
    });

    it('names the same nearest asteroid at every press and change', () => {
      for (const recorded of runs) {
        const run = simulate(scene, recorded.holds, { maxTime: 60 });
        for (const event of run.events) {
          if (event.type !== 'target') continue;
          const frame = Math.round(event.time / TICK);
          const known = recorded.nearest.filter(([from]) => from <= frame).at(-1);
          expect([recorded.name, frame, event.index]).toEqual([recorded.name, frame, known?.[1]]);
        }
      }
    });
  });
}
