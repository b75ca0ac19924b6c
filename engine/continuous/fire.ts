import { recordTarget } from './button.ts';
import { endingOf } from './ending.ts';
import { actingField, countCrossing } from './fields.ts';
import { countSwitch } from './guards/target-switch.ts';
import { locate } from './locate.ts';
import { meet } from './meet.ts';
import type { Motion } from './motion.ts';
import { distanceSquared, nearest } from './nearest.ts';
import { skipOrbits } from './orbits.ts';
import { begin, holdLimits, proceed } from './piece.ts';
import { skipPeriods, skipQuietSteps } from './skip.ts';
import { beginsToSlide, comeOff } from './slide.ts';
import { EVENTS, RECORDS, SLOTS } from './state.ts';
import { stop } from './stop.ts';

const {
  START,
  FROM,
  NEXT,
  EVENT,
  EVENT_A,
  EVENT_B,
  TARGET,
  FIELD,
  COVER,
  LIMIT_X,
  LIMIT_Y,
  OUTCOME,
  TOUCHED,
  END_TIME,
  MINERALS,
  LAST_EVENT,
  LAST_A,
  CROSSED,
  RIM,
} = SLOTS;
const {
  MINERAL,
  NOVA,
  HOT,
  ALIEN_TOUCH,
  HOLE,
  LEAVE_COVER,
  CENTRE,
  SWITCH,
  ENTER,
  LEAVE,
  WAKE,
  SLEEP,
  PAIR,
  LIMIT,
  UNLIMIT,
  COME_OFF,
  PIECE_END,
} = EVENTS;
const { CHASER } = RECORDS;

/** What happens at the event that was located. */
export function fire(m: Motion, until: number): void {
  const { s, scene, recorder } = m;
  const kind = s[EVENT];
  const a = s[EVENT_A];
  const time = s[START] + s[NEXT];
  if (kind === MINERAL) {
    s[m.minerals + a] = 1;
    s[MINERALS]++;
    s[FROM] = s[NEXT];
    recorder?.event({ time, type: 'mineral', index: scene.minerals.index[a] });
    locate(m);
    return;
  }
  stop(m, s[NEXT], time);
  s[LAST_EVENT] = 0;
  if (kind !== PIECE_END && !(kind === CENTRE && a === 0)) s[CROSSED] = 0;
  if (kind === PIECE_END) {
    skipOrbits(m);
    if (m.integrator.glide !== null && recorder === null) skipQuietSteps(m, until);
    // along a rim it is looked at anew whether anything holds her there
    if (s[LIMIT_X] === 0 && s[LIMIT_Y] === 0 && s[RIM] < 0) proceed(m);
    else begin(m);
    return;
  }
  switch (kind) {
    case NOVA:
    case HOT:
    case ALIEN_TOUCH:
    case HOLE:
      end(m, kind, kind === HOT ? scene.targets.index[a] : a, time);
      return;
    case LEAVE_COVER: {
      const other = nearest(m);
      if (other < 0 || other === a || distanceSquared(m, other) > scene.level.range * scene.level.range) {
        end(m, LEAVE_COVER, 0, time);
        return;
      }
      s[COVER] = other;
      break;
    }
    case CENTRE:
      if (a === 1) {
        meet(m);
        break;
      }
      m.ux[0] = 0;
      m.uy[0] = 0;
      skipPeriods(m);
      break;
    case SWITCH:
      countSwitch(m, time);
      s[LAST_EVENT] = SWITCH;
      s[LAST_A] = s[TARGET];
      s[TARGET] = a;
      s[COVER] = a;
      recordTarget(m, time);
      break;
    case ENTER:
    case LEAVE:
      countCrossing(m, time);
      // sliding on the rim she counts as inside
      s[m.inside + a] = 1;
      if (beginsToSlide(m, a) && kind === LEAVE) break;
      s[m.inside + a] = kind === ENTER ? 1 : 0;
      s[FIELD] = actingField(m);
      s[LAST_EVENT] = kind === ENTER ? LEAVE : ENTER;
      s[LAST_A] = a;
      recorder?.event({ time, type: kind === ENTER ? 'enter' : 'leave', index: scene.repulsors.index[a] });
      break;
    case WAKE:
    case SLEEP: {
      const o = m.chasers + CHASER * a;
      s[o + 2] = 0;
      s[o + 3] = 0;
      if (kind === WAKE) m.crowd.wake(a);
      else m.crowd.sleep(a);
      m.near.skin = -1;
      s[LAST_EVENT] = kind === WAKE ? SLEEP : WAKE;
      s[LAST_A] = a;
      recorder?.event({ time, type: kind === WAKE ? 'wake' : 'sleep', index: a });
      break;
    }
    case PAIR:
      m.crowd.explode(a);
      m.crowd.explode(s[EVENT_B]);
      m.near.skin = -1;
      recorder?.event({ time, type: 'explosion', aliens: [a, s[EVENT_B]] });
      break;
    case LIMIT:
      s[a === 0 ? LIMIT_X : LIMIT_Y] = s[EVENT_B];
      holdLimits(m);
      break;
    case UNLIMIT:
      s[LAST_EVENT] = LIMIT;
      s[LAST_A] = a;
      s[a === 0 ? LIMIT_X : LIMIT_Y] = 0;
      break;
    case COME_OFF:
      comeOff(m);
      break;
    default:
  }
  begin(m);
}

function end(m: Motion, kind: number, index: number, time: number): void {
  const { s, recorder } = m;
  s[OUTCOME] = kind;
  s[TOUCHED] = index;
  s[END_TIME] = time;
  const ending = endingOf(m);
  if (ending !== null) recorder?.event({ time, type: ending.outcome, with: ending.with });
}
