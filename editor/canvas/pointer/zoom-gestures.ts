import { type Point, panBy, type View, zoomAt } from '../view.ts';

/** zoom factor per px of wheel */
const WHEEL_ZOOM = 1.0015;
/** px of a wheel line, as some mice report */
const WHEEL_LINE = 16;

/** The view after two fingers have moved from two points of the screen to two others. */
export function pinched(view: View, [a, b]: readonly Point[], [c, d]: readonly Point[]): View {
  const middle = (p: Point, q: Point) => ({ x: (p.x + q.x) / 2, y: (p.y + q.y) / 2 });
  const apart = (p: Point, q: Point) => Math.max(1, Math.hypot(p.x - q.x, p.y - q.y));
  const [from, to] = [middle(a, b), middle(c, d)];
  return zoomAt(panBy(view, to.x - from.x, to.y - from.y), to, apart(c, d) / apart(a, b));
}

/**
 * The view after a turn of the wheel: zoomed at the pointer, with Shift moved sideways. @param at returns the pointer's
 * position, called only if needed
 */
export function wheeled(view: View, event: WheelEvent, at: () => Point): View {
  const unit = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? WHEEL_LINE : 1;
  if (event.shiftKey && !event.ctrlKey) return panBy(view, -(event.deltaX + event.deltaY) * unit, 0);
  // a pinch on a touchpad is reported as a wheel with Ctrl, in small steps
  const factor = WHEEL_ZOOM ** (-event.deltaY * unit * (event.ctrlKey ? 6 : 1));
  return zoomAt(view, at(), factor);
}
