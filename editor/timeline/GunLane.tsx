import { type KeyboardEvent, memo, useRef } from 'react';
import { useStore } from 'zustand';
import type { Hold } from '../../schema/index.ts';
import { useLevel } from '../core/context/index.ts';
import { moveHold, stretchHold } from '../core/document/index.ts';
import type { Grip } from './grip.ts';
import { type EdgeRoom, HoldBar } from './HoldBar.tsx';
import { holdsInWords, type Reached } from './reached.ts';
import { type Scale, toX } from './scale.ts';
import { useHoldDrag } from './use-hold-drag.ts';

const NONE: readonly number[] = [];

interface GunLaneProps {
  /** The name of the run whose holds are shown. */
  readonly run: string;
  readonly holds: readonly Hold[];
  readonly reached: Reached;
  readonly scale: Scale;
  /** Called when a drag begins and ends; the scale must not change in between. */
  readonly onDragging: (isDragging: boolean) => void;
  /** How far each press and release may move alone; null if unknown or outdated. */
  readonly slack: readonly EdgeRoom[] | null;
}

/**
 * The holds of a run as bars: drag to move, drag an end to stretch, double-click to split, drag on the empty lane to add one.
 */
export const GunLane = memo(function GunLane({ run, holds, reached, scale, slack, onDragging }: GunLaneProps) {
  const { document, selection } = useLevel();
  const selected = useStore(selection.store, (state) => (state.run === run ? state.holds : NONE));
  const lane = useRef<HTMLDivElement>(null);
  const drag = useHoldDrag({ lane, run, holds, scale, selected, onDragging });

  const onKey = (event: KeyboardEvent<HTMLElement>, part: Grip['part'], index: number) => {
    if (event.key === 'Escape' && drag.isDragging()) {
      event.stopPropagation();
      drag.cancel();
      return;
    }
    if (event.key !== 'ArrowLeft' && event.key !== 'ArrowRight') return;
    event.preventDefault();
    event.stopPropagation();
    const by = (event.key === 'ArrowLeft' ? -1 : 1) * (event.shiftKey ? 10 : 1);
    const ripple = { ripple: event.altKey };
    const hold = holds[index];
    const recipe =
      part === 'body'
        ? moveHold(run, index, by, ripple)
        : stretchHold(run, index, part, (part === 'press' ? hold[0] : hold[1]) + by, ripple);
    document.change('Move hold', recipe, { gesture: `hold ${run} ${part} ${index}` });
  };

  return (
    <div
      ref={lane}
      className="lane"
      role="application"
      aria-label={`Gun of the run ${run}: ${holdsInWords(holds, reached)}`}
      {...drag.listeners}
    >
      {reached.isBroken && <div className="lane__after" style={{ left: toX(scale, reached.until) }} />}
      {holds.map((hold, index) => (
        <HoldBar
          // Holds have no ids: the index identifies them.
          // biome-ignore lint/suspicious/noArrayIndexKey: see above
          key={index}
          hold={hold}
          index={index}
          reached={reached}
          scale={scale}
          isSelected={selected.includes(index)}
          slack={slack === null ? null : [slack[2 * index], slack[2 * index + 1]]}
          onKey={onKey}
        />
      ))}
    </div>
  );
});
