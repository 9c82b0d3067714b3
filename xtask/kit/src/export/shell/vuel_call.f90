! VUEL of Abaqus/Explicit, by the type of the element.
subroutine vuel(nblock, rhs, amass, dtimestable, svars, nsvars, energy, nnode, ndofel, &
        props, nprops, jprops, njprops, coords, mcrd, u, du, v, a, jtype, jelem, time, period, &
        dtimecur, dtimeprev, kstep, kinc, lflags, dmassscalefactor, predef, npredef, &
        jdltyp, adlmag)
    {uses}
    include 'vaba_param.inc'
    dimension rhs(nblock, ndofel), amass(nblock, ndofel, ndofel), dtimestable(nblock), &
        svars(nblock, nsvars), energy(nblock, 12), props(nprops), jprops(njprops), &
        coords(nblock, nnode, mcrd), u(nblock, ndofel), du(nblock, ndofel), v(nblock, ndofel), &
        a(nblock, ndofel), jelem(nblock), time(2), lflags(3), dmassscalefactor(nblock), &
        predef(nblock, nnode, npredef, 2), adlmag(nblock)
    logical is_well
    do kblock = 1, nblock
        ! No longer than the step.
        if (lflags(3) == 2) dtimestable(kblock) = period
        {calls}
        if (.not. is_well) call xplb_exit
    end do
end subroutine vuel
