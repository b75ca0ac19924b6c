import { EyeOff } from 'lucide-react';
import { useStore } from 'zustand';
import { keyLabel } from '../../core/commands/index.ts';
import { IS_MAC, useEditor, useLevel, useSelectedKeys, useSession } from '../../core/context/index.ts';
import { objectsOf, placesOf } from '../../core/document/index.ts';
import { Segments } from '../../core/panel/index.ts';
import { Button } from '../../core/ui/index.ts';
import type { Feature } from '../feature.ts';
import { LeewayShade } from './LeewayShade.tsx';
import { meaningInWords, movedInWords, noteInWords, PLACE_NAMES, reachInWords, samplingInWords } from './leeway-words.ts';
import { LEEWAY_KEY, leewayOf } from './watch-leeway.ts';
import './leeway.css';

/** Where the selection may stand without the run ending otherwise. */
export const leeway: Feature = {
  name: 'leeway',
  layers: [{ id: 'leeway', title: 'places where the selection may stand', keys: [LEEWAY_KEY], isShown: false }],
  canvas: { labels: LeewayShade, legend: LeewayLegend },
};

/** The legend of the places where the selection may stand, and how far it may go. Empty while they are not shown. */
function LeewayLegend() {
  const { commands } = useEditor();
  const store = leewayOf(useLevel());
  const findings = useStore(store);
  const isShown = useSession(({ layers, mode }) => layers.leeway && mode === 'edit');
  if (!isShown) return null;
  const { answer } = findings;
  return (
    <figure className="shades shades--left leeway-legend" aria-label="Where the selection may stand">
      <figcaption className="leeway-legend__head">
        <b>{answer === null ? 'Where the selection may stand' : `${movedInWords(answer.question)} may stand`}</b>
        <MovedPart />
        {answer !== null && (
          <>
            <p>
              <span className="shades__square leeway-sign" aria-hidden />
              {meaningInWords(answer)}
            </p>
            <p className="leeway-legend__note numbers">{samplingInWords(findings)}</p>
          </>
        )}
        <p className="numbers" role="status">
          {answer === null ? noteInWords(findings) : reachInWords(answer.leeway)}
        </p>
      </figcaption>
      <Button
        hint="Hide where the selection may stand"
        shortcut={keyLabel(LEEWAY_KEY, IS_MAC)}
        icon={<EyeOff size={14} />}
        onClick={() => commands.run('view.layer-leeway')}
      />
    </figure>
  );
}

const ALL = 'both';

/** Which places of a selected object move, if it has several. */
function MovedPart() {
  const level = useLevel();
  const store = leewayOf(level);
  const only = useStore(store, (state) => state.only);
  const keys = useSelectedKeys();
  const found = keys.length === 1 ? objectsOf(level.document.file()).get(keys[0]) : undefined;
  if (found === undefined || placesOf(found).length === 1) return null;
  return (
    <Segments
      label="What is moved"
      value={only === null ? ALL : PLACE_NAMES[only]}
      options={[ALL, ...PLACE_NAMES].map((name) => ({ value: name, title: name }))}
      onChange={(name) =>
        store.setState({ only: name === ALL ? null : PLACE_NAMES.indexOf(name as (typeof PLACE_NAMES)[number]) })
      }
    />
  );
}
