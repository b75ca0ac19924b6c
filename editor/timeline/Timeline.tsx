import { useCallback, useEffect, useLayoutEffect, useMemo, useRef, useState } from 'react';
import { useStore } from 'zustand';
import { useEditor, useLevel, useProof, useSession, useWhenIdle } from '../context/index.ts';
import type { LiveProof } from '../proof/index.ts';
import { EventMarks } from './EventMarks.tsx';
import { Graphs } from './Graphs.tsx';
import { GunLane } from './GunLane.tsx';
import { Ruler } from './Ruler.tsx';
import { rollTimeline } from './roll.ts';
import { runCommands } from './run-commands.ts';
import { fitTicks, panScale, type Scale, toTick, toX, zoomScale } from './scale.ts';
import { Transport } from './Transport.tsx';
import './timeline.css';

/** Zoom by one px of wheel. */
const WHEEL_ZOOM = 1.0015;

const endOf = ({ run }: LiveProof): number => Math.max(1, run.way.count - 1);

/** What takes longest to find out, and may be a frame or two behind the pointer. */
const detailsOf = (proof: LiveProof) => ({ end: endOf(proof), events: proof.full?.events ?? [], margins: proof.margins });

/** Where the shown moment is, and the one under the pointer. */
function Cursors({ scale, end }: { readonly scale: Scale; readonly end: number }) {
  const tick = useSession((state) => state.tick);
  const hoverTick = useSession((state) => state.hoverTick);
  return (
    <>
      {hoverTick !== null && <div className="timeline__hover" style={{ left: toX(scale, hoverTick) }} aria-hidden />}
      <div className="timeline__tick" style={{ left: toX(scale, Math.min(tick, end)) }} aria-hidden />
    </>
  );
}

/** The shown run along time: transport, gun lane, events, speed and clearance. */
export function Timeline() {
  const editor = useEditor();
  const level = useLevel();
  const { session, commands } = editor;
  const name = useProof(({ run }) => run.name);
  const holds = useProof(({ run }) => run.holds);
  const end = useProof(endOf);
  const details = useWhenIdle(level.proof.store, detailsOf);
  const analysis = useStore(level.analysis);
  const box = useRef<HTMLDivElement>(null);
  const [size, setSize] = useState({ width: 600, height: 60 });
  // null: all of the run, however long it is
  const [chosen, setChosen] = useState<Scale | null>(null);
  // while a hold is dragged, though the run may end elsewhere
  const [kept, setKept] = useState<Scale | null>(null);
  const { width } = size;
  const scale = useMemo(() => chosen ?? kept ?? fitTicks(end, width), [chosen, kept, end, width]);
  const drawn = useMemo(() => chosen ?? kept ?? fitTicks(details.end, width), [chosen, kept, details.end, width]);
  const now = useRef({ scale, end });
  now.current = { scale, end };

  useLayoutEffect(() => {
    const element = box.current;
    if (element === null) return;
    const observer = new ResizeObserver(() => setSize({ width: element.clientWidth, height: element.clientHeight }));
    observer.observe(element);
    const onWheel = (event: WheelEvent) => {
      event.preventDefault();
      const x = event.clientX - element.getBoundingClientRect().left;
      const { scale: last } = now.current;
      const sideways = event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY);
      setChosen(sideways ? panScale(last, -(event.deltaX + event.deltaY)) : zoomScale(last, x, WHEEL_ZOOM ** -event.deltaY));
    };
    // React's own wheel listeners can't keep the page from scrolling
    element.addEventListener('wheel', onWheel, { passive: false });
    return () => {
      observer.disconnect();
      element.removeEventListener('wheel', onWheel);
    };
  }, []);
  useEffect(() => rollTimeline(session, () => now.current.end), [session]);
  useEffect(() => {
    const lastTick = () => now.current.end;
    const forget = commands.register([
      ...runCommands(editor, level, lastTick),
      { id: 'run.fit', title: 'Show all of the run in the timeline', group: 'Run', run: () => setChosen(null) },
    ]);
    return forget;
  }, [commands, editor, level]);

  const onDragging = useCallback((isDragging: boolean) => setKept(isDragging ? now.current.scale : null), []);
  const graphs = Math.max(40, size.height - 88);
  const slack = analysis !== null && analysis.holds === holds.join() ? analysis.slack : null;
  return (
    <div className="timeline">
      <Transport end={end} />
      <div
        ref={box}
        className="timeline__box"
        onPointerMove={(event) => {
          if (event.buttons !== 0 || event.pointerType === 'touch') return;
          const at = toTick(scale, event.clientX - event.currentTarget.getBoundingClientRect().left);
          session.setState({ hoverTick: at >= 0 && at <= end ? at : null });
        }}
        onPointerLeave={() => session.setState({ hoverTick: null })}
      >
        <Ruler scale={scale} width={width} end={end} />
        {name === null ? (
          <div className="lane lane--empty">
            No run yet. Play with Space and make the attempt the proof, let the solver find one, or press I to hold the gun from
            here.
          </div>
        ) : (
          <GunLane run={name} holds={holds} scale={scale} slack={slack} onDragging={onDragging} />
        )}
        <EventMarks events={details.events} scale={drawn} width={width} />
        <Graphs margins={details.margins} scale={drawn} width={width} height={graphs} />
        <div className="timeline__end" style={{ left: toX(scale, end) }} aria-hidden />
        <Cursors scale={scale} end={end} />
      </div>
    </div>
  );
}
