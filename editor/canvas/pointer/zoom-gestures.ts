import { type Point, panBy, type View, zoomAt } from '../view.ts';

/** Zoom by one px of wheel. */
const WHEEL_ZOOM = 1.0015;
/** A line of wheel as some mice report it, px. */
const WHEEL_LINE = 16;

/** The view after two fingers have gone from two places of the screen to two others: it is moved and zoomed with them. */
export function pinched(view: View, [a, b]: readonly Point[], [c, d]: readonly Point[]): View {
  const middle = (p: Point, q: Point) => ({ x: (p.x + q.x) / 2, y: (p.y + q.y) / 2 });
  const apart = (p: Point, q: Point) => Math.max(1, Math.hypot(p.x - q.x, p.y - q.y));
  const [from, to] = [middle(a, b), middle(c, d)];
  return zoomAt(panBy(view, to.x - from.x, to.y - from.y), to, apart(c, d) / apart(a, b));
}

/** The view after a turn of the wheel: zoomed at the pointer, with Shift moved across. @param at where the pointer is, asked for only where it matters */
export function wheeled(view: View, event: WheelEvent, at: () => Point): View {
  const unit = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? WHEEL_LINE : 1;
  if (event.shiftKey && !event.ctrlKey) return panBy(view, -(event.deltaX + event.deltaY) * unit, 0);
  // a pinch on a touchpad comes as a wheel with Ctrl, in small steps
  const factor = WHEEL_ZOOM ** (-event.deltaY * unit * (event.ctrlKey ? 6 : 1));
  return zoomAt(view, at(), factor);
}
