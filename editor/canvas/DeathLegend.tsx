import { useMemo } from 'react';
import { useStore } from 'zustand';
import { plural } from '../../check/words/index.ts';
import { heatShades, visitsInWords } from '../../picture/index.ts';
import { useLevel, usePageTheme, useSession } from '../context/index.ts';
import { shelfOf } from '../shelf/index.ts';
import { COLOURS, deathOpacity } from './colours.ts';

/** The legend of the heat map of deaths. Empty while the map is not shown. */
export function DeathLegend() {
  const deaths = useStore(shelfOf(useLevel()).store, (state) => state.deaths);
  const isShown = useSession(({ layers, mode }) => layers.deaths && mode === 'edit');
  const theme = usePageTheme();
  const shades = useMemo(() => (deaths === null || !isShown ? [] : heatShades(deaths)), [deaths, isShown]);
  if (deaths === null || shades.length === 0) return null;
  return (
    <figure className="deathlegend" aria-label="Heat map of deaths">
      <figcaption>
        {plural(deaths.deaths, 'death')}, counted in squares of {deaths.cellSize} px
      </figcaption>
      <ul className="deathlegend__shades numbers">
        {shades.map((shade) => (
          <li key={shade.opacity}>
            <span className="deathlegend__square" aria-hidden>
              <span style={{ background: COLOURS[theme].death, opacity: deathOpacity(shade.opacity) }} />
            </span>
            {visitsInWords(shade)}
          </li>
        ))}
      </ul>
    </figure>
  );
}
