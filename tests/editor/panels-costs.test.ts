import { describe, expect, it } from 'vitest';
import { createProver } from '../../editor/core/proof/index.ts';
import { settingsDiagram } from '../../editor/features/accuracy/measured-settings.ts';
import { otherEndOf } from '../../editor/features/accuracy/OtherAccuracy.tsx';
import { surveyOf } from '../../editor/features/effects/survey.ts';
import { EFFECTS, termsOf, workByEffect } from '../../engine/index.ts';
import { METHODS } from '../../engine/work-precision/index.ts';
import { layOutDiagram } from '../../picture/accuracy/index.ts';
import type { LevelFile } from '../../schema/index.ts';

const FILE: LevelFile = {
  version: 1,
  name: 'all of it',
  astronaut: { x: 0, y: 0 },
  blackHole: { x: 600, y: 0 },
  recoil: true,
  asteroids: [
    { x: 200, y: 30, radius: 16 },
    { x: 420, y: -60, radius: 16, hot: true },
  ],
  novae: [{ x: 100, y: 400, radius: 16 }],
  repulsors: [{ x: 210, y: -80, radius: 48 }],
  aliens: [
    { x: -100, y: 300 },
    { x: -160, y: 340 },
  ],
  minerals: [{ x: 60, y: 9 }],
  winds: [{ x: -200, y: -200, radius: 40 }],
  wormholes: [{ x: -300, y: -100, toX: -300, toY: 100, radius: 20 }],
};
const HOLDS = [[10, 200]] as const;

describe('what an effect costs', () => {
  const live = (accuracy: 'arcade' | 'precise') =>
    createProver(() => 0).prove({
      file: { ...FILE, runs: [{ name: 'swing', holds: [[10, 200]] }] },
      run: null,
      terms: termsOf(accuracy),
      patience: Number.POSITIVE_INFINITY,
    });

  it('is told for every effect that is simulated, as `gq inspect` has it', () => {
    const proof = live('precise');
    const survey = surveyOf(proof);
    expect(survey?.simulated.map(({ work }) => work)).toEqual(workByEffect(proof.scene, HOLDS));
    expect(survey?.simulated.map(({ name }) => name)).toEqual(proof.scene.effects.simulated.map(({ name }) => name));
    expect(survey?.simulated.reduce((sum, { work }) => sum + (work?.guards ?? 0), 0)).toBe(survey?.work.guards);
    expect(survey?.notCalledFor).toEqual([]);
  });

  it('is not told apart under arcade', () => {
    expect(surveyOf(live('arcade'))?.simulated.map(({ work }) => work)).toEqual(EFFECTS.map(() => null));
  });
});

describe('the measured settings', () => {
  it('are points in the diagram, in the theme of the page, with rings around the current one', () => {
    const settings = METHODS.map(({ name }, i) => ({
      name,
      error: 10 ** -(i % 9),
      cost: 1 + i,
      outcome: 'completed' as const,
      with: null,
      time: 1,
      sameVerdict: i !== 3,
    }));
    const run = { name: 'solution', knownTo: 1e-20, doubt: null, unmeasured: [], settings };
    const measured = { runs: [run], level: 'Level <1>', range: 250, played: {} as never, holds: '', left: 0 };
    const draw = (current: 'fast' | 'precise', ground: 'dark' | 'light') =>
      layOutDiagram(settingsDiagram(measured, current, false), ground, 300).svg;
    const svg = draw('fast', 'dark');
    expect(svg.match(/<circle[^>]*r="12.5"/g)).toHaveLength(1);
    expect(svg).not.toBe(draw('precise', 'dark'));
    expect(svg).not.toBe(draw('fast', 'light'));
    // no style element, which would affect the whole page
    expect(svg).not.toContain('<style');
    expect(svg).not.toContain('<1>');
  });
});

describe('what another accuracy would change', () => {
  const proof = (accuracy: 'arcade' | 'precise', msPerLook = 0, patience = Number.POSITIVE_INFINITY) => {
    let clock = 0;
    const now = () => {
      clock += msPerLook;
      return clock;
    };
    return createProver(now).prove({
      file: { ...FILE, runs: [{ name: 'swing', holds: [[10, 200]] }] },
      run: null,
      terms: termsOf(accuracy),
      patience,
    });
  };

  it('is the distance of the two paths, from either side', () => {
    const fromArcade = otherEndOf(proof('arcade'));
    const fromPrecise = otherEndOf(proof('precise'));
    expect(fromArcade).toEqual({ ...fromPrecise, name: 'precise' });
    expect(fromPrecise?.name).toBe('arcade');
    expect(fromArcade?.distance).toBeGreaterThan(0);
  });

  it('is compared however slow the machine was at that moment', () => {
    const slow = proof('arcade', 10_000);
    expect(slow.ms).toBeGreaterThan(1000);
    expect(otherEndOf(slow)).toEqual(otherEndOf(proof('arcade')));
    const cut = proof('arcade', 10_000, 60);
    expect(cut.limit).not.toBeNull();
    expect(otherEndOf(cut)).toEqual(otherEndOf(proof('arcade')));
  });

  it('is left out if it takes too much work, or if nothing is simulated', () => {
    expect(otherEndOf(proof('arcade'), 10)).toBeNull();
    expect(otherEndOf(proof('arcade', 0, 0))).toBeNull();
  });
});
