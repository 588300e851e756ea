# syntax=docker/dockerfile:1

# The digest of the index of all platforms, as docker-library/repo-info records it.
ARG PYTHON=python:3.12.14-slim-bookworm@sha256:0f5b26b9518d002b6173fd61daad821fa340635ebfec5bba471013f9ca114579

# Build: the pinned dependencies and sigcat itself, into one folder that the last stage takes over whole.
FROM ${PYTHON} AS build
WORKDIR /source
ENV PIP_DISABLE_PIP_VERSION_CHECK=1 PIP_NO_CACHE_DIR=1
RUN python -m venv /opt/sigcat && python -m venv /opt/build
COPY requirements.txt requirements-build.txt ./
RUN /opt/sigcat/bin/pip install --require-hashes --requirement requirements.txt
RUN /opt/build/bin/pip install --require-hashes --requirement requirements-build.txt
COPY pyproject.toml README.md LICENSE ./
COPY app app
COPY vspec vspec
COPY overlays overlays
COPY interface_rules interface_rules
COPY examples examples
COPY docs docs
RUN /opt/build/bin/pip wheel --no-deps --no-build-isolation --wheel-dir /opt/wheel . \
 && /opt/sigcat/bin/pip install --no-deps /opt/wheel/*.whl

FROM ${PYTHON}
LABEL org.opencontainers.image.title="sigcat" \
      org.opencontainers.image.description="Signal catalogue and interface standardization service" \
      org.opencontainers.image.licenses="Apache-2.0"
RUN useradd --system --uid 10001 --no-create-home sigcat
COPY --from=build /opt/sigcat /opt/sigcat
RUN mkdir /project /data && chown 10001 /data
# The project is mounted at /project; pulled releases are kept in /data, which may be a volume.
ENV PATH=/opt/sigcat/bin:$PATH PYTHONUNBUFFERED=1 PYTHONDONTWRITEBYTECODE=1 SIGCAT_DATA=/data SIGCAT_HOST=0.0.0.0
USER 10001
WORKDIR /project
EXPOSE 8000
HEALTHCHECK --interval=30s --timeout=3s --start-period=10s \
  CMD ["python", "-m", "sigcat.cli.health_check"]
STOPSIGNAL SIGTERM
ENTRYPOINT ["sigcat"]
CMD ["serve"]
