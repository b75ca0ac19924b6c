import { type KeyboardEvent, memo, type PointerEvent, useRef } from 'react';
import { useEditor, useSession } from '../core/context/index.ts';
import { rulerStep, type Scale, toTick, toX } from './scale.ts';

interface RulerProps {
  readonly scale: Scale;
  readonly width: number;
  /** The last tick that can be shown. */
  readonly end: number;
}

/** px between two labels */
const LABEL_ROOM = 56;

/** Time in seconds; drag on it to scrub. */
export const Ruler = memo(function Ruler({ scale, width, end }: RulerProps) {
  const { session } = useEditor();
  const tick = useSession((state) => Math.round(state.tick));
  const scrubbing = useRef(false);
  const step = rulerStep(scale, LABEL_ROOM);
  const labels: number[] = [];
  for (let at = Math.ceil(scale.from / step) * step; toX(scale, at) <= width; at += step) labels.push(at);

  const scrub = (event: PointerEvent<HTMLDivElement>) => {
    const x = event.clientX - event.currentTarget.getBoundingClientRect().left;
    session.setState({ tick: Math.min(end, Math.max(0, Math.round(toTick(scale, x)))), isPlayingBack: false, hoverTick: null });
  };
  const onKey = (event: KeyboardEvent<HTMLDivElement>) => {
    const by = { ArrowLeft: -1, ArrowRight: 1, PageDown: -60, PageUp: 60 }[event.key];
    const to =
      event.key === 'Home' ? 0 : event.key === 'End' ? end : by === undefined ? null : tick + by * (event.shiftKey ? 10 : 1);
    if (to === null) return;
    event.preventDefault();
    event.stopPropagation();
    session.setState({ tick: Math.min(end, Math.max(0, to)), isPlayingBack: false });
  };
  return (
    <div
      className="ruler numbers"
      role="slider"
      tabIndex={0}
      aria-label="Time"
      aria-valuemin={0}
      aria-valuemax={end}
      aria-valuenow={tick}
      aria-valuetext={`tick ${tick}, ${(tick / 60).toFixed(2)} s`}
      onPointerDown={(event) => {
        event.currentTarget.setPointerCapture(event.pointerId);
        scrubbing.current = true;
        scrub(event);
      }}
      onPointerMove={(event) => scrubbing.current && scrub(event)}
      onPointerUp={() => {
        scrubbing.current = false;
      }}
      onPointerCancel={() => {
        scrubbing.current = false;
      }}
      onKeyDown={onKey}
    >
      {labels.map((at) => (
        <span key={at} className="ruler__label" style={{ left: toX(scale, at) }}>
          {Number((at / 60).toFixed(1))} s
        </span>
      ))}
    </div>
  );
});
