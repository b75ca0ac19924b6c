import { afterEach, describe, expect, it, vi } from 'vitest';
import { EffectSet } from '../../engine/effects/index.ts';
import { compile, EFFECTS, type Effect } from '../../engine/index.ts';
import { type Level, type OwnRules, RULE_NAMES, RULES } from '../../schema/index.ts';
import { PROVERS, type Proof, proveBy, proveImpossible, proveMineralsUnreachable, verifyProof } from '../../solver/index.ts';
import { effectsOf, whyNotTried } from '../../solver/prove/assumptions.ts';
import { mayProve } from '../../solver/prove/index.ts';
import type { Prover } from '../../solver/prove/proof.ts';
import { isDeep, itQuick } from '../depth.ts';
import { ALSO, LEVELS } from './impossible-levels.ts';

// A force of which the proofs know nothing: the game suddenly has it, and levels call for it. What was proved without it may
// now be false.

const WIND: Effect = {
  name: 'test-wind',
  summary: () => 'pushes her somewhere',
  calledFor: () => ({ called: true, because: 'the wind blows everywhere' }),
};
const game = EFFECTS as Effect[];
const blow = () => {
  game.push(WIND);
  const choose = EffectSet.prototype.choose;
  vi.spyOn(EffectSet.prototype, 'choose').mockImplementation(function (this: EffectSet, level) {
    const chosen = choose.call(this, level);
    return { ...chosen, simulated: [...chosen.simulated, { name: WIND.name, because: WIND.calledFor(level).because }] };
  });
};
const calm = () => {
  vi.restoreAllMocks();
  game.pop();
};

afterEach(() => {
  vi.restoreAllMocks();
  if (game.at(-1) === WIND) game.pop();
});

const HOLE = { kind: 'blackHole' } as const;
const KINDS = Object.keys(PROVERS) as Prover[];
const levelFor = (kind: Prover) => LEVELS[kind === 'dead-end' ? 'line-trap with a dead end' : kind];
const certificateKind = (kind: Prover): Proof['code'] => (kind === 'dead-end' ? 'line-trap' : kind);

describe.each(KINDS)('%s', (kind) => {
  const level = levelFor(kind);

  it('may apply to a level of which it proves something, and not with the wind', () => {
    expect(mayProve(kind, level)).toBe(true);
    blow();
    expect(mayProve(kind, level)).toBe(false);
  });

  itQuick('has a proof without the wind and none with it, and the checker refuses the old one', () => {
    const proof = proveBy(kind, level, HOLE) as Proof;
    expect(proof.code).toBe(certificateKind(kind));
    expect(verifyProof(level, proof)).toEqual({ ok: true });
    blow();
    // A level calls for it as the engine decides, not as this test does.
    expect(compile(level).effects.simulated.map(({ name }) => name)).toContain('test-wind');
    expect(proveBy(kind, level, HOLE)).toBeNull();
    expect(verifyProof(level, proof)).toEqual({
      ok: false,
      why: 'the level calls for the effect test-wind, which proofs of this kind do not cover',
    });
    calm();
    expect(proveBy(kind, level, HOLE)).toEqual(proof);
    expect(verifyProof(level, proof)).toEqual({ ok: true });
  });

  it('gives the reason', () => {
    expect(whyNotTried(kind, effectsOf(level))).toBeNull();
    blow();
    expect(whyNotTried(kind, effectsOf(level))).toBe(`the level calls for test-wind, which ${kind} does not cover`);
  });
});

describe('there is no other way to a proof', () => {
  it.each(Object.keys(LEVELS).filter((name) => isDeep || name !== 'orbits'))(
    '%s: no other prover proves it, or that its minerals are out of reach',
    (name) => {
      const level = LEVELS[name];
      const lost = proveMineralsUnreachable(level);
      expect(proveImpossible(level)?.code).toBe(ALSO[name]?.[0] ?? name);
      blow();
      expect(proveImpossible(level)).toBeNull();
      expect(proveMineralsUnreachable(level)).toEqual([]);
      expect(lost.filter((proof) => verifyProof(level, proof).ok)).toEqual([]);
    },
  );

  it('an effect that a level does not call for does not prevent a proof', () => {
    const level = LEVELS.enclosed;
    game.push({ ...WIND, calledFor: () => ({ called: false, because: 'no wind' }) });
    const proof = proveImpossible(level) as Proof;
    game.pop();
    expect(proof.code).toBe('enclosed');
    expect(verifyProof(level, proof)).toEqual({ ok: true });
  });
});

describe('a rule of which the proofs know nothing', () => {
  const withRule = (of: Level): Level => ({ ...of, rules: { drag: 0.1 } as OwnRules });

  it.each(KINDS)('%s: has no proof with it, and the checker refuses the old one', (kind) => {
    const level = levelFor(kind);
    const proof = proveBy(kind, level, HOLE) as Proof;
    expect(whyNotTried(kind, effectsOf(withRule(level)))).toBe(`the level calls for the rule drag, which ${kind} does not cover`);
    expect(proveBy(kind, withRule(level), HOLE)).toBeNull();
    expect(verifyProof(withRule(level), proof)).toEqual({
      ok: false,
      why: 'the level sets the rule drag, which no proof covers',
    });
  });
});

describe('the declarations', () => {
  // An effect that changes its name is unknown to every kind. This test reports it before a level does.
  it.each(EFFECTS.map(({ name }) => name))('each kind of proof understands %s, or is known not to', (name) => {
    const not = KINDS.filter((kind) => whyNotTried(kind, [name]) !== null);
    expect(not).toEqual(name === 'recoil' ? ['dead-end'] : []);
  });

  it.each(RULE_NAMES)('the bounds of provers and checker use the rule %s', (name) => {
    const level = { ...LEVELS.enclosed, rules: { [name]: RULES[name].default } };
    expect(whyNotTried('enclosed', effectsOf(level))).toBeNull();
    expect(verifyProof(level, proveBy('enclosed', level, HOLE) as Proof)).toEqual({ ok: true });
  });

  it('an unknown name is understood by no kind of proof', () => {
    for (const kind of KINDS) {
      for (const name of ['', 'gu', 'test-wind', 'constructor']) expect(whyNotTried(kind, [name])).not.toBeNull();
    }
  });
});
