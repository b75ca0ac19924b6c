import { Vector } from './arithmetic.ts';
import type { Places } from './places.ts';
import { type Chart, type Drifts, ON_RIM, type Scene, TIE } from './scene.ts';

/** Nearer to a centre than this, px, a force may point anywhere. */
const AT_CENTRE = 1;

/**
 * All accelerations that are possible at some places of a chart, along the axes of these {@link Places}: of her relative to the
 * chart's asteroid, px/s², with the gun on or off at any instant.
 */
export class Forces {
  /** Those of everything but the chart's own asteroid. */
  readonly others = new Vector();
  /** All of them. */
  readonly all = new Vector();
  /** Whether nothing but the chart's own asteroid may act, so that angular momentum is preserved. */
  isCentral = true;
  private readonly fields = new Vector();
  private readonly scene: Scene;
  private readonly places: Places;
  private readonly drifts: Drifts;
  /** Numbers in `rocks` of the asteroids that may be the target, and what was measured of them. */
  private readonly rivals: Float64Array;

  constructor(scene: Scene, places: Places, drifts: Drifts) {
    this.scene = scene;
    this.places = places;
    this.drifts = drifts;
    this.rivals = new Float64Array(7 * scene.charts.length);
  }

  /** Looks at the places in the chart of asteroid i. */
  look(i: number): void {
    const { scene, places, drifts, others, all, fields } = this;
    const { rules, range } = scene;
    const chart = scene.charts[i];
    const mayPull = this.lookAtRocks(chart, i);
    const inField = this.lookAtFields(chart, drifts.of(i));
    if (inField === ALWAYS) others.set(fields.a0, fields.a1, fields.b0, fields.b1);
    else if (inField === PERHAPS) others.join(fields.a0, fields.a1, fields.b0, fields.b1);
    if (inField !== NEVER) this.isCentral = false;
    all.set(others.a0, others.a1, others.b0, others.b1);
    if (mayPull && inField !== ALWAYS) {
      const strongest = Math.max(0, rules.pull - (rules.pull * places.least) / range);
      this.own(strongest, true);
    }
    // The asteroid accelerates towards her while the gun is held, in a field as well.
    if (mayPull && chart.recoil > 0) this.own(1.01 * chart.recoil, false);
    this.lookAtWinds(chart, drifts.of(i));
  }

  /** Adds an acceleration of at most `strongest` towards the chart's asteroid, or none. */
  private own(strongest: number, instead: boolean): void {
    const { all, places } = this;
    const { least } = places;
    let [a0, a1, b0, b1] = [-strongest, 0, 0, 0];
    if (!places.isSector) {
      a1 = b1 = strongest;
      b0 = -strongest;
      if (least > AT_CENTRE) {
        const perPx = strongest / least;
        a0 = Math.max(a0, Math.min(0, -places.x1 * perPx));
        a1 = Math.min(a1, Math.max(0, -places.x0 * perPx));
        b0 = Math.max(b0, Math.min(0, -places.y1 * perPx));
        b1 = Math.min(b1, Math.max(0, -places.y0 * perPx));
      }
    }
    if (instead) all.join(a0, a1, b0, b1);
    else all.add(a0, a1, b0, b1);
  }

  /** Sets the pull of other asteroids, or none; returns whether the chart's own asteroid may be the target. */
  private lookAtRocks({ rocks }: Chart, i: number): boolean {
    const { places, drifts, rivals, scene, others } = this;
    const { pull } = scene.rules;
    others.set(0, 0, 0, 0);
    this.isCentral = true;
    let mayPull = true;
    let reach = places.most;
    let count = 0;
    const farthest = drifts.farthestRival(places.most);
    for (const rock of rocks) {
      // Nothing that is at the places can be nearer to this asteroid, or to those beyond.
      if (rock.r > farthest) break;
      places.look(rock.x, rock.y, rock.r);
      const blur = drifts.between(i, rock.index);
      const half = (rock.r * rock.r) / 2;
      const slack = drifts.slack(blur, rock, places.most);
      if (places.dot0 > half + slack) mayPull = false;
      if (places.dot1 < half - slack) continue;
      const o = 7 * count++;
      rivals[o] = Math.max(0, places.near - blur);
      rivals[o + 1] = places.far + blur;
      rivals[o + 2] = places.ahead0 - blur;
      rivals[o + 3] = places.ahead1 + blur;
      rivals[o + 4] = places.beside0 - blur;
      rivals[o + 5] = places.beside1 + blur;
      reach = Math.min(reach, places.far + blur);
    }
    for (let k = 0; k < count; k++) {
      const o = 7 * k;
      const near = rivals[o];
      if (near > reach + TIE) continue;
      this.isCentral = false;
      const strongest = Math.max(0, pull - (pull * near) / scene.range);
      if (near < AT_CENTRE) {
        others.join(-strongest, strongest, -strongest, strongest);
        continue;
      }
      const perPx = strongest / near;
      others.join(
        Math.max(-strongest, Math.min(0, rivals[o + 2] * perPx)),
        Math.min(strongest, Math.max(0, rivals[o + 3] * perPx)),
        Math.max(-strongest, Math.min(0, rivals[o + 4] * perPx)),
        Math.min(strongest, Math.max(0, rivals[o + 5] * perPx)),
      );
    }
    return mayPull;
  }

  /** Sets `fields` to the pushes of all fields that may act; returns whether any does. */
  private lookAtFields(chart: Chart, blur: number): typeof NEVER | typeof PERHAPS | typeof ALWAYS {
    const { places, fields, scene } = this;
    const { push } = scene.rules;
    let found: typeof NEVER | typeof PERHAPS | typeof ALWAYS = NEVER;
    for (const field of chart.fields) {
      if (places.areFarFrom(field, field.radius + blur + ON_RIM)) continue;
      places.look(field.x, field.y, field.r);
      const near = Math.max(0, places.near - blur);
      const far = places.far + blur;
      if (near > field.radius + ON_RIM) continue;
      let [a0, a1, b0, b1] = [-push, push, -push, push];
      if (near > AT_CENTRE) {
        const [weak, strong] = [push / far, push / near];
        const away = (c: number) => (c > 0 ? c * strong : c * weak);
        const back = (c: number) => (c > 0 ? c * weak : c * strong);
        a1 = Math.min(a1, away(blur - places.ahead0));
        a0 = Math.max(a0, back(-blur - places.ahead1));
        b1 = Math.min(b1, away(blur - places.beside0));
        b0 = Math.max(b0, back(-blur - places.beside1));
      }
      if (found === NEVER) fields.set(a0, a1, b0, b1);
      else fields.join(a0, a1, b0, b1);
      if (far < field.radius - ON_RIM) found = ALWAYS;
      else if (found === NEVER) found = PERHAPS;
    }
    return found;
  }

  /** Adds winds to everything. */
  private lookAtWinds(chart: Chart, blur: number): void {
    const { places, others, all } = this;
    for (const wind of chart.winds) {
      if (places.areBeyond(wind, wind.radius + blur + ON_RIM)) continue;
      const isIn = places.far + blur < wind.radius - ON_RIM;
      places.look(wind.ax, wind.ay, wind.strength);
      const least = (n: number) => (isIn ? n : Math.min(0, n));
      const most = (n: number) => (isIn ? n : Math.max(0, n));
      const a0 = least(places.along0);
      const a1 = most(places.along1);
      const b0 = least(places.aside0);
      const b1 = most(places.aside1);
      others.add(a0, a1, b0, b1);
      all.add(a0, a1, b0, b1);
      this.isCentral = false;
    }
  }
}

const NEVER = 0;
const PERHAPS = 1;
const ALWAYS = 2;
