import { ChevronFirst, ChevronLast, Pause, Play, StepBack, StepForward, ZoomIn, ZoomOut } from 'lucide-react';
import { memo } from 'react';
import { useDocument, useEditor, useProof, useSession } from '../core/context/index.ts';
import { endInWords } from '../core/proof/index.ts';
import { RATE_NAMES, RATES } from '../core/session/index.ts';
import { Button } from '../core/ui/index.ts';
import { holdsInWords, type Reached } from './holds.ts';
import type { NamedPart } from './part.ts';
import { TimelineLegend } from './TimelineLegend.tsx';

/** The shown moment in words; a component of its own, as it changes with every frame of a scrub. */
function Moment({ end }: { readonly end: number }) {
  const tick = useSession((state) => Math.round(state.tick));
  return (
    <span className="numbers">
      tick {tick} {tick > end ? 'past' : 'of'} {end} · {(tick / 60).toFixed(2)} s
    </span>
  );
}

/** The holds of the shown run and its end in words; a component of its own, as it changes with every step of a drag. */
function Summary({ reached }: { readonly reached: Reached }) {
  const ends = useProof((now) => endInWords(now));
  const good = useProof((now) => now.run.outcome === 'completed');
  const holds = useProof((now) => now.run.holds);
  const summary = `${holdsInWords(holds, reached)}, ${ends}`;
  return (
    <span className={good ? 'transport__end transport__end--good' : 'transport__end'} title={summary}>
      {summary}
    </span>
  );
}

interface ControlsProps {
  /** What features of the page show in the timeline. */
  readonly parts: readonly NamedPart[];
  /** Whether the legend is open. */
  readonly isExplained: boolean;
  readonly onExplain: (isExplained: boolean) => void;
}

/** Which run is shown, and what steps, plays back and scrubs. Memoized, so that a drag does not redraw it. */
const Controls = memo(function Controls({ parts, isExplained, onExplain }: ControlsProps) {
  const { session, commands } = useEditor();
  const runs = useDocument(({ file }) => file.runs);
  const shown = useProof((now) => now.run.name);
  const isPlayingBack = useSession((state) => state.isPlayingBack);
  const rate = useSession((state) => state.rate);
  return (
    <>
      <select
        className="field"
        aria-label="Run"
        value={shown ?? ''}
        onChange={(event) => session.setState({ run: event.target.value === '' ? null : event.target.value })}
      >
        {shown === null && <option value="">no run: she drifts</option>}
        {(runs ?? []).map(({ name }) => (
          <option key={name} value={name}>
            {name}
          </option>
        ))}
      </select>
      <Button
        hint="Go to the start of the run"
        shortcut="Home"
        icon={<ChevronFirst size={16} />}
        onClick={() => commands.run('run.first')}
      />
      <Button hint="Previous tick" shortcut="," icon={<StepBack size={16} />} onClick={() => commands.run('run.back')} />
      <Button
        hint={isPlayingBack ? 'Pause' : 'Play back the run'}
        shortcut="K"
        icon={isPlayingBack ? <Pause size={16} /> : <Play size={16} />}
        onClick={() => commands.run('run.playback')}
      />
      <Button hint="Next tick" shortcut="." icon={<StepForward size={16} />} onClick={() => commands.run('run.on')} />
      <Button
        hint="Go to the end of the run"
        shortcut="End"
        icon={<ChevronLast size={16} />}
        onClick={() => commands.run('run.last')}
      />
      <div className="transport__rates" role="toolbar" aria-label="Playback speed">
        {RATES.map((one) => (
          <Button
            key={one}
            hint={`${RATE_NAMES[one]} speed`}
            pressed={rate === one}
            onClick={() => session.setState({ rate: one })}
          >
            {RATE_NAMES[one]}
          </Button>
        ))}
      </div>
      {/* A wheel or a touchpad zooms without these buttons, which are for touch. */}
      <div className="transport__zoom" role="toolbar" aria-label="Timeline zoom">
        <Button hint="Zoom the timeline out" icon={<ZoomOut size={16} />} onClick={() => commands.run('run.zoom-out')} />
        <Button hint="Zoom the timeline in" icon={<ZoomIn size={16} />} onClick={() => commands.run('run.zoom-in')} />
      </div>
      {parts.map(({ name: part, buttons: Buttons }) => Buttons && <Buttons key={part} />)}
      <TimelineLegend parts={parts} isOpen={isExplained} onOpen={onExplain} />
    </>
  );
});

interface TransportProps extends ControlsProps {
  readonly end: number;
  readonly reached: Reached;
}

/** Which run is shown, and the moment in it: step, play back, scrub. */
export const Transport = memo(function Transport({ parts, end, reached, isExplained, onExplain }: TransportProps) {
  return (
    <div className="transport">
      <Controls parts={parts} isExplained={isExplained} onExplain={onExplain} />
      <Moment end={end} />
      <Summary reached={reached} />
    </div>
  );
});
