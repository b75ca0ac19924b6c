import { useMemo } from 'react';
import { useStore } from 'zustand';
import { heatCaption, heatColour, heatShades, visitsInWords } from '../../../picture/index.ts';
import { usePageTheme, useSession } from '../../context/index.ts';
import { useSolverSession } from './use-solver-session.ts';
import './solver.css';

/**
 * The legend of the heat map: what the squares count, and which shade means how many visits. Empty while the heat map is
 * hidden.
 */
export function HeatLegend() {
  const { overlay } = useSolverSession();
  const explored = useStore(overlay, ({ heat }) => heat);
  const isShown = useSession(({ layers }) => layers.heatMap);
  const theme = usePageTheme();
  const shades = useMemo(() => (explored === null || !isShown ? [] : heatShades(explored)), [explored, isShown]);
  if (explored === null || shades.length === 0) return null;
  return (
    <figure className="heatlegend" aria-label="Search heat map">
      <figcaption>{heatCaption(explored)}</figcaption>
      <ul className="heatlegend__shades numbers">
        {shades.map((shade) => (
          <li key={shade.opacity}>
            <span className="heatlegend__square" aria-hidden>
              <span style={{ background: heatColour(theme), opacity: shade.opacity }} />
            </span>
            {visitsInWords(shade)}
          </li>
        ))}
      </ul>
    </figure>
  );
}
