/**
 * A radial gradient with the id `gq-ID`.
 * @param place attributes for its centre and radius; by default those of the shape that it fills
 */
export const radial = (
  id: string,
  stops: readonly (readonly [offset: number, color: string, opacity?: number])[],
  place = '',
): string =>
  `<radialGradient id="gq-${id}"${place}>${stops
    .map(([offset, color, opacity]) => {
      const alpha = opacity === undefined ? '' : ` stop-opacity="${opacity}"`;
      return `<stop offset="${offset}" stop-color="${color}"${alpha}/>`;
    })
    .join('')}</radialGradient>`;
