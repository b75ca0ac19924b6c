import { EyeOff } from 'lucide-react';
import { useStore } from 'zustand';
import { useEditor, useLevel, useProof, useSession } from '../../core/context/index.ts';
import { isWhole } from '../../core/proof/index.ts';
import { Button } from '../../core/ui/index.ts';
import { briefLossInWords } from './loss-words.ts';
import { lostOf } from './lost-store.ts';
import { countLost, lostInWords } from './lost-words.ts';
import { useRunLoss } from './use-run-loss.ts';
import './lost.css';

/** The legend of the shade of lost states, and since when the shown run was lost. Empty while they are not shown. */
export function LostLegend() {
  const { commands } = useEditor();
  const findings = useStore(lostOf(useLevel()));
  const isShown = useSession(({ layers, mode }) => layers.lost && mode === 'edit');
  const name = useProof(({ run }) => run.name);
  const time = useProof((proof) => (isWhole(proof) ? proof.run.time : null));
  const loss = useRunLoss();
  if (!isShown) return null;
  const since = loss === null || time === null ? null : briefLossInWords(loss, time);
  const { proved, notFound } = countLost(findings);
  const { phase, losing } = findings;
  return (
    <figure className="shades shades--left lost-legend" aria-label="Lost states">
      <figcaption className="lost-legend__head">
        <b>Lost although she lives on</b>
        {losing !== null && (
          <ul className="shades__list lost-legend__list numbers">
            <li>
              <span className="shades__square lost-sign lost-sign--proved" aria-hidden />
              proved lost: {proved}
            </li>
            <li>
              <span className="shades__square lost-sign lost-sign--open" aria-hidden />
              no run found: {notFound}
            </li>
          </ul>
        )}
        <p className={phase === 'needs a run' || phase === 'failed' ? 'lost-legend__note' : 'unseen'} role="status">
          {lostInWords(findings)}
        </p>
        <p className="lost-legend__run numbers" role="status">
          {since !== null && (
            <>
              <b>{name ?? 'Without a run'}</b>: {since}
            </>
          )}
        </p>
      </figcaption>
      <Button
        hint="Hide the lost states"
        shortcut="L"
        icon={<EyeOff size={14} />}
        onClick={() => commands.run('view.layer-lost')}
      />
    </figure>
  );
}
