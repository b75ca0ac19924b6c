import { chaserTravel, eventRule, justFired, offer, offerContact, offerFrom, quietOutside, rimTime } from '../../events/index.ts';
import { FOLLOWERS, GOES_ON, type Motion, ONSETS, placeChaser, RECORDS, SERIES, SLOTS } from '../../motion/index.ts';
import { SURPLUS } from '../../tolerances.ts';
import { type Effect, type EngineEffect, whereAny } from '../effect.ts';
import { AlienCrowd } from './crowd.ts';
import { NOBODY } from './meetings-of-many.ts';
import { overlapping, pairTime } from './pair.ts';

const { START, NEXT, EVENT, ONSET, LENGTH_H, AWAKE_COUNT, LAST_EVENT, LAST_A } = SLOTS;
const { CHASER } = RECORDS;
const { STANDS } = ONSETS;

/** What overlaps at the start has exploded by this time, s. */
const AT_THE_START = 1e-9;

/** The crowd that `attach` made. */
const crowdOf = (m: Motion): AlienCrowd => m.crowd as AlienCrowd;

/** She touches an alien. Sleeping ones are in the neighbour list, under this event and under {@link wake}. */
const touchAlien = eventRule({
  name: 'alien',
  ends: { outcome: 'collided', touches: 'alien' },
  list(m) {
    const { near } = m;
    const { r } = m.scene.aliens;
    crowdOf(m).eachSleeperNear(near.x, near.y, near.skin, (i, d) => {
      near.add(wake.kind, i, d - m.rules.alienSight - SURPLUS);
      near.add(touchAlien.kind, i, d - r[i] - m.touchMargin);
    });
  },
  guard: offerTouch,
  quiet(m, i, time) {
    const o = m.chasers + CHASER * i;
    return quietOutside(m, m.s[o], m.s[o + 1], m.scene.aliens.r[i] + m.touchMargin, time);
  },
  always: offerAwake,
  fire: (_m, i) => i,
});

function offerTouch(m: Motion, i: number, from: number): void {
  placeChaser(m, i);
  const pull = m.circleMotion === SERIES ? m.rules.alienPull : 0;
  offerContact(m, m.scene.aliens.r[i], pull, touchAlien.kind, i, from);
}

/** Her centre comes so near to an alien that it sees her. */
const wake = eventRule({
  name: 'wake',
  guard(m, i, from) {
    placeChaser(m, i);
    offer(m, rimTime(m, m.rules.alienSight, true, 0, from, justFired(m, wake.kind, i)), wake.kind, i, 0);
  },
  quiet(m, i, time) {
    const o = m.chasers + CHASER * i;
    return quietOutside(m, m.s[o], m.s[o + 1], m.rules.alienSight + SURPLUS, time);
  },
  fire: (m, i, _b, time) => become(m, i, true, time),
});

/** An awake alien loses sight of her. */
const fallAsleep = eventRule({
  name: 'sleep',
  fire: (m, i, _b, time) => become(m, i, false, time),
});

function offerSleep(m: Motion, i: number, from: number): void {
  placeChaser(m, i);
  offer(
    m,
    rimTime(m, m.rules.alienSight, false, m.rules.alienPull, from, justFired(m, fallAsleep.kind, i)),
    fallAsleep.kind,
    i,
    0,
  );
}

function become(m: Motion, i: number, awake: boolean, time: number): number {
  const { s } = m;
  const o = m.chasers + CHASER * i;
  s[o + 2] = 0;
  s[o + 3] = 0;
  if (awake) crowdOf(m).wake(i);
  else crowdOf(m).sleep(i);
  m.near.skin = -1;
  s[LAST_EVENT] = awake ? fallAsleep.kind : wake.kind;
  s[LAST_A] = i;
  m.recorder?.event({ time, type: awake ? 'wake' : 'sleep', index: i });
  return GOES_ON;
}

/** Two aliens touch. */
const explode = eventRule({
  name: 'explosion',
  fire(m, i, j, time) {
    crowdOf(m).explode(i);
    crowdOf(m).explode(j);
    m.near.skin = -1;
    m.recorder?.event({ time, type: 'explosion', aliens: [i, j] });
    return GOES_ON;
  },
});

/** The explosion of two that overlap at the start stands; of two that only touch it waits for the button, as her contacts do. */
function offerPair(m: Motion, i: number, j: number, from: number): void {
  const time = pairTime(m, i, j, from);
  offerFrom(m, time, explode.kind, i, j, from, m.s[START] === 0 && overlapping(m, i, j));
}

/** Offers events of awake aliens and of pairs with one of them; at the start also of pairs that overlap. */
function offerAwake(m: Motion, from: number): void {
  const { s, path } = m;
  const { aliens } = m.scene;
  const { explosions } = aliens;
  if (s[AWAKE_COUNT] === 0 && (s[START] >= AT_THE_START || explosions.length === 0)) return;
  const crowd = crowdOf(m);
  const h = s[LENGTH_H];
  // the first two that overlap at their places in the level, asleep; an awake one is handled with its pairs
  let overlap = explosions.length > 0 ? crowd.overlapAtStart() : -1;
  // once two that touch at once are found, all other pairs come later, unless one may stand
  const isEnough = (): boolean =>
    s[EVENT] <= explode.kind && s[NEXT] - m.sameInstant <= from && (s[START] > 0 || s[ONSET] === STANDS);
  const visit = (i: number, j: number): void => {
    if (overlap >= 0 && explosions[overlap] <= i) {
      offerPair(m, explosions[overlap], explosions[overlap + 1], from);
      overlap = -1;
    }
    if (j !== NOBODY) {
      if (!isEnough()) offerPair(m, i, j, from);
      return;
    }
    const o = m.chasers + CHASER * i;
    const d = Math.sqrt((s[o] - path.x) * (s[o] - path.x) + (s[o + 1] - path.y) * (s[o + 1] - path.y));
    const moves = path.travel + chaserTravel(m, i, m.rules.alienPull, h);
    if (d + moves > m.rules.alienSight - SURPLUS) offerSleep(m, i, from);
    if (d - moves < aliens.r[i] + m.touchMargin) offerTouch(m, i, from);
  };
  if (s[AWAKE_COUNT] > 0) crowd.meetings(h, isEnough, visit);
  if (overlap >= 0) offerPair(m, explosions[overlap], explosions[overlap + 1], from);
}

/** Places the aliens where the level has them; those that see her are awake. */
function layOutAliens(m: Motion): void {
  const { s, scene } = m;
  const { aliens } = scene;
  for (let i = 0; i < aliens.count; i++) {
    const o = m.chasers + CHASER * i;
    s[o] = aliens.x[i] - m.originX;
    s[o + 1] = aliens.y[i] - m.originY;
    if (s[o] * s[o] + s[o + 1] * s[o + 1] >= m.rules.alienSight * m.rules.alienSight) continue;
    crowdOf(m).wake(i);
  }
}

export const alienChase: EngineEffect = {
  name: 'alien-chase',
  summary: ({ alienSight, alienPull }) =>
    `an alien within ${alienSight} px accelerates towards her at ${alienPull} px/s2, otherwise it stops dead; touching it ends the run`,
  calledFor: whereAny('aliens', 'alien'),
  rules: ['alienPull', 'alienSight'],
  chase: {
    kind: 'alien',
    circles: ({ aliens }) => aliens,
    pull: ({ alienPull }) => alienPull,
    sight: ({ alienSight }) => alienSight,
  },
  following: FOLLOWERS,
  moves: true,
  kills: true,
  hazard: ({ aliens }) => ({ kind: 'alien', circles: aliens, first: 0, movedBy: 'chase' }),
  events: [touchAlien, wake, fallAsleep],
  attach(m) {
    m.crowd = new AlienCrowd(m, m.vicinities[touchAlien.kind]);
  },
  layOut: layOutAliens,
};

export const alienExplosion: Effect = {
  name: 'alien-explosion',
  summary: () => 'two aliens that touch explode',
  calledFor: (level) => {
    const n = level.aliens.length;
    return n > 1 ? { called: true, because: `${n} aliens` } : { called: false, because: 'fewer than two aliens' };
  },
  events: [explode],
};
